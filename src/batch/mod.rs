//! Requests and answers as JSON, one a line.

mod decode;

use std::io::{self, BufRead, BufReader, Read, Write};

use serde_json::value::RawValue;

use crate::model::{Fault, Fields};
use crate::ops::Operation;
use crate::report::stream::output_text;

/// The most bytes of one request.
pub const MAX_LINE: usize = 16 << 20;

/// Answers every line of `input` with one line of `output`, in order.
///
/// Memory does not grow with the number of lines, and every answer is written
/// before the next line is waited for. A line that cannot be used is answered
/// with an error and ends nothing; blank lines are passed over.
///
/// # Errors
/// Those of reading and writing.
pub fn run(input: impl Read, mut output: impl Write) -> io::Result<()> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let mut line = Vec::new();
    loop {
        if !input.buffer().contains(&b'\n') {
            output.flush()?;
        }
        line.clear();
        // One byte more than the limit, to tell a long line from one that fits.
        if input.by_ref().take(MAX_LINE as u64 + 1).read_until(b'\n', &mut line)? == 0 {
            return output.flush();
        }
        if line.len() > MAX_LINE && line.last() != Some(&b'\n') {
            skip_line(&mut input)?;
            let fault = Fault::new("too-large", format!("a request may have at most {MAX_LINE} bytes"));
            write_answer(&mut output, None, None, Err(fault))?;
        } else if !line.trim_ascii().is_empty() {
            answer(&line, &mut output)?;
        }
    }
}

fn skip_line(input: &mut impl BufRead) -> io::Result<()> {
    loop {
        let buffer = input.fill_buf()?;
        let (length, done) = match buffer.iter().position(|&byte| byte == b'\n') {
            Some(end) => (end + 1, true),
            None => (buffer.len(), buffer.is_empty()),
        };
        input.consume(length);
        if done {
            return Ok(());
        }
    }
}

fn answer(line: &[u8], output: &mut impl Write) -> io::Result<()> {
    let Ok(text) = std::str::from_utf8(line) else {
        return write_answer(output, None, None, Err(Fault::new("bad-json", "the line is not valid UTF-8")));
    };
    let raw: &RawValue = match serde_json::from_str(text) {
        Ok(raw) => raw,
        Err(error) => {
            let message = format!("not JSON: {error}");
            return write_answer(output, None, None, Err(Fault::new("bad-json", message)));
        }
    };
    let request = match Fields::of(raw, "a request") {
        Ok(request) => request,
        Err(fault) => return write_answer(output, None, None, Err(fault)),
    };
    let (id, op) = (request.get("id"), request.get("op"));
    write_answer(output, id, op, carry_out(&request))
}

fn carry_out(request: &Fields<'_>) -> Result<String, Fault> {
    let name: String = crate::model::plain(request.require("op", "a request")?, "the name of an operation")?;
    let operation = Operation::named(&name).ok_or_else(|| unknown_operation(&name))?;
    let arguments = decode::arguments(operation, request.require("input", "a request")?)?;
    Ok(output_text(&operation.on_numbers(&arguments)?)?)
}

/// Says what there is instead: the operations with the most similar names.
fn unknown_operation(name: &str) -> Fault {
    let name = crate::model::excerpt(name);
    let mut known: Vec<(f64, &str)> =
        crate::ops::operations().map(|operation| (strsim::jaro_winkler(&name, operation.name), operation.name)).collect();
    known.sort_by(|a, b| b.0.total_cmp(&a.0));
    let nearest: Vec<String> = known.iter().take(4).map(|(_, name)| format!("`{name}`")).collect();
    Fault::new("unknown-op", format!("there is no operation `{name}`; the nearest names are {}", nearest.join(", ")))
}

/// Writes an answer; `id` and `op` go back as they were spelled.
fn write_answer(output: &mut impl Write, id: Option<&RawValue>, op: Option<&RawValue>, result: Result<String, Fault>) -> io::Result<()> {
    write!(output, "{{\"id\":{}", id.map_or("null", RawValue::get))?;
    match result {
        Ok(found) => writeln!(output, ",\"op\":{},\"output\":{found}}}", op.map_or("null", RawValue::get)),
        Err(fault) => writeln!(output, ",\"error\":{}}}", serde_json::json!({"code": fault.code, "message": fault.message})),
    }
}
