//! A model as Rust source: what is committed runs without a description.
//!
//! The text is as rustfmt leaves it, needs no heap and no std, and gives the same bits as
//! [`Tape::evaluate`].

mod body;
mod expression;
mod functions;
mod layout;
mod names;
mod number;
mod scope;
mod table;

use std::collections::BTreeSet;

use equations::table::ModelTable;

use self::body::FunctionBody;
use self::functions::FunctionPurpose;
use self::scope::ArgumentNames;
use self::table::Constant as _;
use crate::tape::{Instruction, Tape};

/// Returns the source of a module: `TABLE`, a unit structure that is the model's
/// [`Functions`](equations::table::Functions), and one function per tape.
///
/// `source` is the description that it was made from, as the first line says it.
pub fn rust(table: &ModelTable, functions: &[Tape], source: &str) -> String {
    let purposes = functions::purposes(table, functions.len());
    let names = ArgumentNames::new(table);
    let roles = step_roles(table, functions);
    let in_step: BTreeSet<usize> = roles.iter().flat_map(|it| it.1.iter().copied()).collect();
    let bodies: Vec<String> = functions
        .iter()
        .zip(&purposes)
        .enumerate()
        .map(|(at, (tape, purpose))| {
            let attribute = if in_step.contains(&at) { "#[inline(always)]\n" } else { "" };
            function(tape, purpose, &names, attribute)
        })
        .collect();
    let structure = format!("{}Functions", names::type_name(table.name));
    let constant = table_constant(table);
    let dispatch = dispatch(&structure, &roles, &purposes);
    let code = format!("{constant}\n{dispatch}\n{}", bodies.join("\n"));
    format!("{}{}\n{code}", header(source), imports(&code))
}

/// Which rules a generated file does not follow.
const RULES: &str = "\
#![allow(
    non_snake_case,
    unreachable_pub,
    clippy::allow_attributes,
    clippy::inline_always,
    clippy::large_stack_frames,
    clippy::suspicious_operation_groupings,
    clippy::too_many_lines,
    clippy::unnecessary_wraps,
    reason = \"names as in the description, straight lines of operations: what applies varies\"
)]

";

/// Says what the file is.
fn header(source: &str) -> String {
    let source: String = source.chars().filter(|it| !it.is_control()).collect();
    format!(
        "//! Emitted from `{source}` by `letoff model emit`; not to be changed by hand.\n{RULES}"
    )
}

/// The names that emitted code may use, by where they are imported from.
const IMPORTS: [(&str, &[&str]); 3] = [
    ("contacts", &["ContactSpec", "FrictionSpec"]),
    (
        "equations::table",
        &[
            "Arguments",
            "BodyTable",
            "ContactModeTable",
            "ContactTable",
            "DamperTable",
            "DrawingTable",
            "Freedom",
            "FunctionId",
            "Functions",
            "GuardTable",
            "Material",
            "MidiTable",
            "ModeTable",
            "ModelTable",
            "NamedQuantity",
            "OutlineTable",
            "ParameterTable",
            "PartTable",
            "PresetTable",
            "PressureKind",
            "PressureTable",
            "RequirementTable",
            "RestTable",
            "RestingTable",
            "SeriesTable",
            "SpringTable",
            "WayTable",
        ],
    ),
    ("pode", &["EquationKind", "Fires", "GuardId", "GuardSpec", "Part", "Reads", "math"]),
];

/// The imports that `code` needs, as rustfmt orders and breaks them.
fn imports(code: &str) -> String {
    let used: BTreeSet<&str> = words(code).collect();
    let mut text = String::new();
    for (path, names) in IMPORTS {
        if path == "equations::table" && used.contains("functions") {
            text.push_str("use equations::functions;\n");
        }
        let names: Vec<&str> = names.iter().filter(|it| used.contains(**it)).copied().collect();
        text.push_str(&import(path, &names));
    }
    text
}

fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|it: char| !it.is_ascii_alphanumeric() && it != '_')
}

fn import(path: &str, names: &[&str]) -> String {
    match names {
        [] => return String::new(),
        [only] => return format!("use {path}::{only};\n"),
        _ => {}
    }
    let line = format!("use {path}::{{{}}};\n", names.join(", "));
    if line.len() <= layout::WIDTH + 1 {
        return line;
    }
    let names: Vec<String> = names.iter().map(|it| (*it).to_owned()).collect();
    // rustfmt keeps the last column of imports free.
    let lines = layout::filled(&names, 5);
    format!("use {path}::{{\n    {},\n}};\n", lines.join(",\n    "))
}

fn table_constant(table: &ModelTable) -> String {
    let prefix = "pub static TABLE: ModelTable = ";
    let value = table.literal().print(0, prefix.len(), 1);
    format!("/// All of the model but its arithmetic.\n{prefix}{value};\n")
}

/// The structure, with a `match` for all functions, and one for each role that a step asks for.
fn dispatch(
    structure: &str,
    roles: &[(&str, BTreeSet<usize>)],
    purposes: &[FunctionPurpose],
) -> String {
    let all = (0..purposes.len()).collect();
    let call = method("call", &all, purposes, "return");
    let roles: String = roles
        .iter()
        .filter(|(_, functions)| !functions.is_empty())
        .map(|(role, functions)| {
            format!("\n    #[inline(always)]\n{}", method(role, functions, purposes, "None"))
        })
        .collect::<Vec<_>>()
        .concat();
    format!(
        "/// The model's arithmetic.\n\
         #[derive(Clone, Copy, Debug, Default)]\n\
         pub struct {structure};\n\n\
         impl Functions for {structure} {{\n{call}{roles}}}\n"
    )
}

/// A method that tells `functions` apart, and does `other` for the rest.
fn method(
    name: &str,
    functions: &BTreeSet<usize>,
    purposes: &[FunctionPurpose],
    other: &str,
) -> String {
    let arms: String = functions
        .iter()
        .map(|at| format!("            {at} => {}(given, out),\n", purposes[*at].name))
        .collect::<Vec<_>>()
        .concat();
    format!(
        "    fn {name}(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {{\n        \
         let done = match function {{\n\
         {arms}            \
         _ => {other},\n        \
         }};\n        \
         if done.is_none() {{\n            \
         out.fill(f64::NAN);\n        \
         }}\n    \
         }}\n"
    )
}

/// Most operations of one role that are to be part of each step: more of them cost more time to
/// fetch than their calls.
const MOST_IN_STEP: usize = 200;

/// The functions that a step asks for, by the methods of [`Functions`](equations::table::Functions);
/// none for a method that stays a call.
fn step_roles(table: &ModelTable, functions: &[Tape]) -> [(&'static str, BTreeSet<usize>); 4] {
    let modes = || table.modes.iter();
    let guards = || modes().flat_map(|mode| mode.guards);
    let mut roles: [(&str, BTreeSet<usize>); 4] = [
        ("derivative", modes().map(|mode| usize::from(mode.derivative)).collect()),
        ("readout", modes().map(|mode| usize::from(mode.readout)).collect()),
        ("guard", guards().map(|guard| usize::from(guard.value)).collect()),
        ("bound", guards().filter_map(|guard| guard.bound.map(usize::from)).collect()),
    ];
    for (_, role) in &mut roles {
        let tapes = role.iter().filter_map(|at| functions.get(*at));
        if tapes.map(operations).sum::<usize>() > MOST_IN_STEP {
            role.clear();
        }
    }
    roles
}

/// How many operations a function takes.
fn operations(tape: &Tape) -> usize {
    let is_given =
        |it: &&Instruction| matches!(it, Instruction::Number(_) | Instruction::Argument(_));
    tape.instructions.len() - tape.instructions.iter().filter(is_given).count()
}

fn function(
    tape: &Tape,
    purpose: &FunctionPurpose,
    names: &ArgumentNames,
    attribute: &str,
) -> String {
    let given = if FunctionBody::reads_arguments(tape) { "given" } else { "_" };
    let out = if tape.outputs.is_empty() { "_" } else { "out" };
    let lines = FunctionBody::new(tape, names).finish();
    let statements: String =
        lines.iter().map(|line| format!("    {line}\n")).collect::<Vec<_>>().concat();
    format!(
        "/// {}\n{attribute}fn {}({given}: &Arguments<'_>, {out}: &mut [f64]) -> Option<()> {{\n\
         {statements}    Some(())\n}}\n",
        purpose.doc, purpose.name
    )
}
