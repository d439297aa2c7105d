//! The JSON of `check`.

use std::io::{self, Write};

use serde::Serialize;

use super::rules::rule_of;
use super::{Examined, File, Summary};
use crate::audit::{Join, Verdict};
use crate::continuity::Continuity;
use crate::exact::Rational;

#[derive(Serialize)]
struct Document<'a> {
    version: u8,
    files: Vec<FileRecord<'a>>,
    summary: SummaryRecord,
}

#[derive(Serialize)]
struct SummaryRecord {
    joins: usize,
    exact: usize,
    within: usize,
    violated: usize,
    degenerate: usize,
    reported: usize,
    known: usize,
    unreadable: usize,
}

#[derive(Serialize)]
#[serde(untagged)]
enum FileRecord<'a> {
    Examined {
        path: &'a str,
        format: &'static str,
        pieces: usize,
        open_edges: usize,
        collapsed_edges: usize,
        branches: usize,
        omitted: usize,
        joins: Vec<JoinRecord>,
    },
    Unreadable {
        path: &'a str,
        error: ErrorRecord<'a>,
    },
}

#[derive(Serialize)]
struct ErrorRecord<'a> {
    message: &'a str,
    line: Option<u32>,
    column: Option<u32>,
}

#[derive(Serialize)]
struct SideRecord {
    piece: usize,
    edge: &'static str,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Order {
    Finite(i64),
    Infinite(&'static str),
}

#[derive(Serialize)]
struct JoinRecord {
    a: SideRecord,
    b: SideRecord,
    reversed: bool,
    verdict: &'static str,
    c: Order,
    g: i64,
    ratio: Option<String>,
    sin2: Option<[String; 2]>,
    obtuse: bool,
    offset2: Option<String>,
    rounding: &'static str,
    require: Option<&'static str>,
    rule: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fingerprint: Option<String>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    known: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    contour: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    node: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<u32>,
}

fn record(examined: &Examined, index: usize, join: &Join) -> JoinRecord {
    let side = |(piece, side): (usize, crate::side::Side)| SideRecord { piece, edge: side.name() };
    let stated = examined.stated(join);
    JoinRecord {
        a: side(join.first),
        b: side(join.second),
        reversed: join.reversed,
        verdict: join.verdict.name(),
        c: match join.parametric {
            Continuity::Broken => Order::Finite(-1),
            Continuity::C(order) => Order::Finite(i64::try_from(order).unwrap_or(i64::MAX)),
            Continuity::Same => Order::Infinite("inf"),
        },
        g: join.geometric.map_or(-1, |order| i64::try_from(order).unwrap_or(i64::MAX)),
        ratio: join.ratio.as_ref().map(Rational::to_string),
        sin2: join.sin2.as_ref().map(|bounds| bounds.each_ref().map(Rational::to_string)),
        obtuse: join.obtuse,
        offset2: join.offset2.as_ref().map(Rational::to_string),
        rounding: join.rounding.name(),
        require: join.requirement.map(|requirement| requirement.name()),
        rule: rule_of(join).map(|rule| rule.code),
        fingerprint: examined.fingerprints[index].clone(),
        known: examined.known[index],
        contour: stated.map(|joint| joint.contour),
        node: stated.map(|joint| joint.node),
        line: stated.map(|joint| joint.place.line),
        column: stated.map(|joint| joint.place.column),
    }
}

/// Writes what was found as one JSON document.
///
/// # Errors
/// What writing gives.
pub fn json(files: &[File], out: &mut dyn Write) -> io::Result<()> {
    let summary = Summary::of(files);
    let count = |verdict| summary.count(verdict);
    let document = Document {
        version: 1,
        files: files.iter().map(file_record).collect(),
        summary: SummaryRecord {
            joins: summary.joins,
            exact: count(Verdict::Exact),
            within: count(Verdict::Within),
            violated: count(Verdict::Violated),
            degenerate: count(Verdict::Degenerate),
            reported: count(Verdict::Reported),
            known: summary.known,
            unreadable: summary.unreadable,
        },
    };
    serde_json::to_writer(&mut *out, &document)?;
    writeln!(out)
}

fn file_record(file: &File) -> FileRecord<'_> {
    match &file.outcome {
        Err(flaw) => FileRecord::Unreadable {
            path: &file.path,
            error: ErrorRecord {
                message: &flaw.message,
                line: flaw.place.map(|place| place.line),
                column: flaw.place.map(|place| place.column),
            },
        },
        Ok(examined) => FileRecord::Examined {
            path: &file.path,
            format: examined.model.format.name(),
            pieces: examined.model.parts.len(),
            open_edges: examined.audit.open,
            collapsed_edges: examined.audit.collapsed,
            branches: examined.audit.branches,
            omitted: examined.model.omissions.len(),
            joins: examined.audit.joins.iter().enumerate().map(|(index, join)| record(examined, index, join)).collect(),
        },
    }
}
