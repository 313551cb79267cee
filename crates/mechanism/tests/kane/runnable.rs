//! Runnable models from descriptions, for all tests.

use std::sync::LazyLock;

use instruments::equations::table::ModelTable;
use instruments::equations::{EquationModel, ModeNumber};
use mechanism::kane::assemble::Program;
use mechanism::kane::{DerivedModel, derive_model};
use pode::{GuardId, Guarded as _};

use crate::kane::shipped::{Folder, files};

/// Interpreted model, with its state first in N entries, and room for C constants.
pub(crate) type Runnable<const N: usize, const C: usize = 256> =
    EquationModel<&'static Program, N, C>;

pub(crate) fn runnable<const N: usize, const C: usize>(
    program: Program,
    values: &[f64],
) -> Runnable<N, C> {
    ShippedModel::of(program).valued(values)
}

pub(crate) type Run<const N: usize> = Runnable<N, 512>;

pub(crate) fn model<const N: usize>(derived: DerivedModel, (preset, key): (usize, u8)) -> Run<N> {
    let it = ShippedModel::of(derived.program);
    it.valued(&it.values(preset, key))
}

pub(crate) fn described(text: &str) -> DerivedModel {
    derive_model("it.toml", text, &Folder).unwrap_or_else(|mistakes| panic!("{mistakes}"))
}

/// Returns the model of a mass that `text` describes, with one mode and the input s (m).
pub(crate) fn mass(text: &str) -> Run<2> {
    let text = format!(
        r#"
name = "mass"
summary = "a mass that touches"
{text}
[input]
name = "s"
unit = "m"
per_metre = "1"

[modes.only]

[rest]
mode = "only"
"#
    );
    model(described(&text), (0, 0))
}

pub(crate) fn shipped(name: &str) -> String {
    let texts = files().into_iter().map(|file| std::fs::read_to_string(file).expect("a file"));
    let mut named = texts.filter(|text| text.starts_with(&format!("name = \"{name}\"")));
    named.next().unwrap_or_else(|| panic!("no description of {name}"))
}

pub(crate) struct ShippedModel {
    pub(crate) table: &'static ModelTable,
    program: &'static Program,
}

impl ShippedModel {
    pub(crate) fn of(program: Program) -> Self {
        let program = Box::leak(Box::new(program));
        Self { table: &program.table, program }
    }

    fn named(name: &str) -> Self {
        Self::of(described(&shipped(name)).program)
    }

    pub(crate) fn valued<const N: usize, const C: usize>(&self, values: &[f64]) -> Runnable<N, C> {
        EquationModel::new(self.program, values).expect("there is room for it")
    }

    pub(crate) fn values(&self, preset: usize, key: u8) -> Vec<f64> {
        let mut values = vec![0.0; self.table.parameters.len()];
        self.valued::<16, 512>(&[]).preset(preset, key, &mut values);
        values
    }

    pub(crate) fn model<const N: usize>(
        &self,
        preset: &str,
        key: u8,
        changes: &[(&str, f64)],
    ) -> Runnable<N> {
        let number = self.table.presets.iter().position(|it| it.name == preset);
        let mut values = self.values(number.expect("a preset"), key);
        for (name, value) in changes {
            values[parameter(self.table, name)] = *value;
        }
        self.valued(&values)
    }
}

fn parameter(table: &ModelTable, name: &str) -> usize {
    let index = table.parameters.iter().position(|it| it.name == name);
    index.unwrap_or_else(|| panic!("{} has no parameter {name}", table.name))
}

pub(crate) static RIGID: LazyLock<ShippedModel> =
    LazyLock::new(|| ShippedModel::named("key-hammer-rigid"));
pub(crate) static SPRINGS: LazyLock<ShippedModel> =
    LazyLock::new(|| ShippedModel::named("key-hammer-springs"));
pub(crate) static GRAND: LazyLock<ShippedModel> =
    LazyLock::new(|| ShippedModel::named("reduced-grand"));
pub(crate) static BALL: LazyLock<ShippedModel> =
    LazyLock::new(|| ShippedModel::named("bouncing-ball"));
pub(crate) static CART: LazyLock<ShippedModel> =
    LazyLock::new(|| ShippedModel::named("cart-pendulum"));
pub(crate) static WALL: LazyLock<ShippedModel> =
    LazyLock::new(|| ShippedModel::named("spring-wall"));

pub(crate) fn built_in() -> [&'static ShippedModel; 6] {
    [&RIGID, &SPRINGS, &GRAND, &BALL, &CART, &WALL]
}

pub(crate) fn value<const N: usize>(model: &Runnable<N>, name: &str) -> f64 {
    model.parameters()[parameter(model.table(), name)]
}

pub(crate) fn mode<const N: usize>(model: &Runnable<N>, name: &str) -> ModeNumber {
    let number = model.table().modes.iter().position(|it| it.name == name);
    ModeNumber(u8::try_from(number.expect("a mode")).expect("few modes"))
}

pub(crate) fn modes<const N: usize>(
    model: &Runnable<N>,
) -> impl Iterator<Item = (ModeNumber, &'static str)> + use<'_, N> {
    (0..).map(ModeNumber).zip(model.table().modes.iter().map(|it| it.name))
}

pub(crate) fn mode_name<const N: usize>(model: &Runnable<N>, mode: ModeNumber) -> &'static str {
    model.table().modes[usize::from(mode.0)].name
}

#[track_caller]
pub(crate) fn guard<const N: usize>(model: &Runnable<N>, mode: ModeNumber, name: &str) -> GuardId {
    model.guards(mode).iter().find(|it| it.name == name).expect("a guard").id
}

#[track_caller]
pub(crate) fn output<const N: usize>(
    model: &Runnable<N>,
    mode: ModeNumber,
    (x, input): (&[f64; N], &pode::Motion),
    name: &str,
) -> f64 {
    let mut out = [0.0; 64];
    model.outputs(mode, x, input, &mut out);
    let index = model.table().outputs.iter().position(|it| it.name == name);
    out[index.unwrap_or_else(|| panic!("no output {name}"))]
}
