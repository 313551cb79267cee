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
use crate::tape::Tape;

/// Returns the source of a module: `TABLE`, a unit structure that is the model's
/// [`Functions`](equations::table::Functions), and one function per tape.
///
/// `source` is the description that it was made from, as the first line says it.
pub fn rust(table: &ModelTable, functions: &[Tape], source: &str) -> String {
    let purposes = functions::purposes(table, functions.len());
    let names = ArgumentNames::new(table);
    let bodies: Vec<String> = functions
        .iter()
        .zip(&purposes)
        .map(|(tape, purpose)| function(tape, purpose, &names))
        .collect();
    let structure = format!("{}Functions", names::type_name(table.name));
    let constant = table_constant(table);
    let dispatch = dispatch(&structure, &purposes);
    let code = format!("{constant}\n{dispatch}\n{}", bodies.join("\n"));
    format!("{}{}\n{code}", header(source), imports(&code))
}

/// Which rules a generated file does not follow.
const RULES: &str = "\
#![allow(
    non_snake_case,
    unreachable_pub,
    clippy::allow_attributes,
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
            "ModeTable",
            "ModelTable",
            "NamedQuantity",
            "OutlineTable",
            "ParameterTable",
            "PartTable",
            "PresetTable",
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

/// The structure and its one `match`.
fn dispatch(structure: &str, purposes: &[FunctionPurpose]) -> String {
    let arms: String = purposes
        .iter()
        .enumerate()
        .map(|(at, purpose)| format!("            {at} => {}(given, out),\n", purpose.name))
        .collect::<Vec<_>>()
        .concat();
    format!(
        "/// The model's arithmetic.\n\
         #[derive(Clone, Copy, Debug, Default)]\n\
         pub struct {structure};\n\n\
         impl Functions for {structure} {{\n    \
         fn call(&self, function: FunctionId, given: &Arguments<'_>, out: &mut [f64]) {{\n        \
         let done = match function {{\n\
         {arms}            \
         _ => return,\n        \
         }};\n        \
         if done.is_none() {{\n            \
         out.fill(f64::NAN);\n        \
         }}\n    \
         }}\n\
         }}\n"
    )
}

fn function(tape: &Tape, purpose: &FunctionPurpose, names: &ArgumentNames) -> String {
    let given = if FunctionBody::reads_arguments(tape) { "given" } else { "_" };
    let out = if tape.outputs.is_empty() { "_" } else { "out" };
    let lines = FunctionBody::new(tape, names).finish();
    let statements: String =
        lines.iter().map(|line| format!("    {line}\n")).collect::<Vec<_>>().concat();
    format!(
        "/// {}\nfn {}({given}: &Arguments<'_>, {out}: &mut [f64]) -> Option<()> {{\n\
         {statements}    Some(())\n}}\n",
        purpose.doc, purpose.name
    )
}
