//! Requests and answers as JSON, one a line.

mod decode;

use std::io::{self, BufRead, BufReader, Read, Write};
use std::num::NonZero;
use std::thread;

use serde_json::value::RawValue;

use crate::model::{Fault, Fields, without_place};
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
    let mut input = BufReader::with_capacity(1 << 17, input);
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    let mut line = Vec::new();
    loop {
        let waiting = complete_lines(input.buffer());
        if workers > 1 && waiting >= MANY {
            answer_together(&input.buffer()[..waiting], workers, MOST_HELD, &mut output)?;
            input.consume(waiting);
        }
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

/// How many bytes of lines have to be waiting for it to be worth to share them among threads.
const MANY: usize = 1 << 13;

/// The bytes of answers that a thread keeps until it is its turn to write, but for the last answer.
const MOST_HELD: usize = 1 << 22;

/// The length of all complete lines at the beginning of what has been read.
fn complete_lines(buffer: &[u8]) -> usize {
    buffer.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1)
}

/// Answers lines that have all been read already, at the same time but in their order.
fn answer_together(lines: &[u8], workers: usize, most_held: usize, output: &mut impl Write) -> io::Result<()> {
    let mut parts = Vec::with_capacity(workers);
    let mut rest = lines;
    for part in (1..=workers).rev() {
        // About the same number of bytes for everybody, up to the end of a line.
        let share = rest.len() / part;
        let end = rest[share..].iter().position(|&byte| byte == b'\n').map_or(rest.len(), |end| share + end + 1);
        let (own, others) = rest.split_at(if part == 1 { rest.len() } else { end });
        parts.push(own);
        rest = others;
    }
    thread::scope(|scope| {
        let (first, others) = parts.split_first().map_or((&[][..], &[][..]), |(first, others)| (*first, others));
        let others: Vec<_> = others.iter().map(|&part| scope.spawn(move || answered(part, most_held))).collect();
        finish(answered(first, most_held), output)?;
        for other in others {
            finish(other.join().map_err(|_| io::Error::other("a request could not be answered"))?, output)?;
        }
        Ok(())
    })
}

/// The answers to lines, up to where they take too much memory, and the lines that are left.
fn answered(mut lines: &[u8], most_held: usize) -> (Vec<u8>, &[u8]) {
    let mut answers = Vec::new();
    while !lines.is_empty() && answers.len() < most_held {
        let end = lines.iter().position(|&byte| byte == b'\n').map_or(lines.len(), |end| end + 1);
        let (line, rest) = lines.split_at(end);
        lines = rest;
        if !line.trim_ascii().is_empty() {
            // Writing to memory does not fail.
            let _ = answer(line, &mut answers);
        }
    }
    (answers, lines)
}

/// Writes answers, and those to the lines that are left one by one.
fn finish((answers, rest): (Vec<u8>, &[u8]), output: &mut impl Write) -> io::Result<()> {
    output.write_all(&answers)?;
    let lines = rest.split(|&byte| byte == b'\n').filter(|line| !line.trim_ascii().is_empty());
    lines.into_iter().try_for_each(|line| answer(line, output))
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
    let raw: &RawValue = match serde_json::from_str(text.trim_end()) {
        Ok(raw) => raw,
        Err(error) => {
            let message = format!("not JSON: {}, in column {}", without_place(&error), error.column());
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write as _;

    /// Requests good and bad, blank lines among them, of many lengths.
    fn requests(count: usize) -> String {
        let mut text = String::new();
        for id in 0..count {
            let request = match id % 5 {
                0 => format!("{{\"id\": {id}, \"op\": \"sigma\", \"input\": {{\"values\": [{}]}}}}", vec!["1"; id % 40].join(",")),
                1 => format!("{{\"id\": {id}, \"op\": \"nonsense\", \"input\": {{}}}}"),
                2 => String::new(),
                3 => "not JSON".to_owned(),
                _ => format!("{{\"id\": {id}, \"op\": \"cubic.class\", \"input\": {{\"points\": [[0,0],[1,{id}],[0,1],[1,0]]}}}}"),
            };
            writeln!(text, "{request}").expect("a string");
        }
        text
    }

    #[test]
    fn answers_of_several_threads_are_in_order() {
        let text = requests(1000);
        let mut alone = Vec::new();
        for line in text.lines().filter(|line| !line.is_empty()) {
            answer(line.as_bytes(), &mut alone).expect("writing memory");
        }
        for (workers, most_held) in [(1, MOST_HELD), (2, MOST_HELD), (5, MOST_HELD), (3, 1000), (2, 0)] {
            let mut together = Vec::new();
            answer_together(text.as_bytes(), workers, most_held, &mut together).expect("writing memory");
            assert!(together == alone, "{workers} workers");
        }
        let mut streamed = Vec::new();
        run(text.as_bytes(), &mut streamed).expect("reading and writing memory");
        assert!(streamed == alone);
        // Without a line end behind the last request.
        let mut streamed = Vec::new();
        run(text.trim_end().as_bytes(), &mut streamed).expect("reading and writing memory");
        assert!(streamed == alone);
    }
}
