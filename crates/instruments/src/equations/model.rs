//! A model of a table and of functions by number.

use pode::Motion;

use crate::equations::mode_number::ModeNumber;
use crate::equations::natures::{MAX_MODES, ModeNatures};
use crate::equations::table::{Arguments, Equations, FunctionId, ModeTable, ModelTable};

/// A model whose equations are functions by number, with its constants in the object.
///
/// The state has N entries; those beyond the table's stay 0. There is room for C constants.
#[derive(Clone, Copy, Debug)]
pub struct EquationModel<F, const N: usize, const C: usize> {
    functions: F,
    constants: [f64; C],
    natures: ModeNatures,
}

static NOTHING: ModeTable = ModeTable::NOTHING;

/// Reason why a table does not fit into an [`EquationModel`], with the number it needs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DoesNotFit {
    States(usize),
    Constants(usize),
    Modes(usize),
}

impl<F: Equations, const N: usize, const C: usize> PartialEq for EquationModel<F, N, C> {
    fn eq(&self, other: &Self) -> bool {
        core::ptr::eq(self.functions.table(), other.functions.table())
            && self.constants == other.constants
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Builds a model with one value per parameter; a missing one comes from the default preset.
    /// Fails if the table has more states, constants or modes than there is room for.
    ///
    /// # Real-time
    /// Bounded: Newton's method twice, and for each mode two Jacobians.
    pub fn new(functions: F, parameters: &[f64]) -> Result<Self, DoesNotFit> {
        let mut model = Self::without_natures(functions, parameters)?;
        model.natures = ModeNatures::of(&model);
        Ok(model)
    }

    /// Like [`new`](Self::new), but without the natures of its modes.
    pub(crate) fn without_natures(functions: F, parameters: &[f64]) -> Result<Self, DoesNotFit> {
        const { assert!(N > 0 && N <= 64, "a part has a bit for each entry") };
        fits(functions.table(), (N, C))?;
        let natures = ModeNatures::default();
        let mut model = Self { functions, constants: [0.0; C], natures };
        model.constants = model.derived(parameters);
        Ok(model)
    }

    /// Like [`new`](Self::new) with other parameters, and with the same bound.
    #[must_use]
    pub fn with_values(&self, parameters: &[f64]) -> Self {
        let mut model = self.clone();
        model.natures = ModeNatures::default();
        model.constants = model.derived(parameters);
        model.natures = ModeNatures::of(&model);
        model
    }

    fn derived(&self, parameters: &[f64]) -> [f64; C] {
        let count = self.table().parameters.len();
        let mut constants = [0.0; C];
        if parameters.len() < count {
            self.preset(0, 0, &mut constants);
        }
        for (constant, value) in constants.iter_mut().zip(parameters).take(count) {
            *constant = *value;
        }
        let mut derived = [0.0; C];
        let arguments = Arguments {
            constants: constants.get(..count).unwrap_or(&constants),
            state: &[],
            input: &[0.0; 4],
            extra: &[],
        };
        self.functions.call(self.table().constants.derive, &arguments, &mut derived);
        for (constant, value) in constants.iter_mut().skip(count).zip(derived) {
            *constant = value;
        }
        constants
    }

    /// Writes the parameters in the preset `index` for a key, 0 (A0) to 87 (C8).
    pub fn preset(&self, index: usize, key: u8, values: &mut [f64]) {
        let Some(preset) = self.table().presets.get(index) else { return };
        let extra = [f64::from(key)];
        let arguments = Arguments { constants: &[], state: &[], input: &[0.0; 4], extra: &extra };
        self.functions.call(preset.values, &arguments, values);
    }

    #[inline]
    pub fn table(&self) -> &ModelTable {
        self.functions.table()
    }

    #[inline]
    pub const fn functions(&self) -> &F {
        &self.functions
    }

    pub fn parameters(&self) -> &[f64] {
        self.constants.get(..self.table().parameters.len()).unwrap_or(&self.constants)
    }

    pub(crate) const fn natures(&self) -> &ModeNatures {
        &self.natures
    }

    /// Returns the table of a mode; an empty table for an unknown number.
    #[inline]
    pub(crate) fn mode_table(&self, mode: ModeNumber) -> &ModeTable {
        self.table().modes.get(usize::from(mode.0)).unwrap_or(&NOTHING)
    }

    #[inline]
    pub(crate) fn call(&self, function: FunctionId, x: &[f64; N], input: &Motion, out: &mut [f64]) {
        self.call_with(function, (x, &rates_of(input)), &[], out);
    }

    #[inline]
    pub(crate) fn call_with(
        &self,
        function: FunctionId,
        (state, input): (&[f64], &[f64; 4]),
        extra: &[f64],
        out: &mut [f64],
    ) {
        self.functions.call(function, &self.arguments(state, input, extra), out);
    }

    #[expect(clippy::inline_always, reason = "a call takes the arguments through memory")]
    #[inline(always)]
    pub(crate) const fn arguments<'a>(
        &'a self,
        state: &'a [f64],
        input: &'a [f64; 4],
        extra: &'a [f64],
    ) -> Arguments<'a> {
        Arguments { constants: &self.constants, state, input, extra }
    }

    /// Returns the K values of a function; all NaN without a function.
    #[inline]
    pub(crate) fn values<const K: usize>(
        &self,
        function: FunctionId,
        x: &[f64; N],
        input: &Motion,
    ) -> [f64; K] {
        let mut out = [f64::NAN; K];
        self.call(function, x, input, &mut out);
        out
    }

    /// Returns a state and the K numbers behind it, at most 2 N.
    pub(crate) fn state_and_numbers<const K: usize>(
        &self,
        function: FunctionId,
        x: &[f64; N],
        input: &Motion,
    ) -> ([f64; N], [f64; K]) {
        let mut out = [[0.0; N]; 3];
        self.call(function, x, input, out.as_flattened_mut());
        self.split(&out)
    }

    pub(crate) fn split<const K: usize>(&self, out: &[[f64; N]; 3]) -> ([f64; N], [f64; K]) {
        let count = self.table().states.len();
        let number = |i: usize| out.as_flattened().get(count + i).copied().unwrap_or(0.0);
        let numbers = core::array::from_fn(number);
        (core::array::from_fn(|i| if i < count { out[0][i] } else { 0.0 }), numbers)
    }

    /// Returns the derivative of the rates by the state, row by row.
    pub(crate) fn jacobian_rows(
        &self,
        function: FunctionId,
        x: &[f64; N],
        input: &Motion,
    ) -> [[f64; N]; N] {
        let mut out = [[0.0; N]; N];
        self.call(function, x, input, out.as_flattened_mut());
        let count = self.table().states.len();
        if count == N {
            return out;
        }
        let mut rows = [[0.0; N]; N];
        for (row, entries) in
            rows.iter_mut().zip(out.as_flattened().chunks_exact(count.max(1))).take(count)
        {
            row[..count].copy_from_slice(entries);
        }
        rows
    }
}

#[expect(clippy::inline_always, reason = "a call takes the input through memory")]
#[inline(always)]
pub(crate) const fn rates_of(input: &Motion) -> [f64; 4] {
    let Motion { position, rate, acceleration, jerk } = *input;
    [position, rate, acceleration, jerk]
}

/// Checks that the table fits into `room.0` state entries and `room.1` constants.
fn fits(table: &ModelTable, room: (usize, usize)) -> Result<(), DoesNotFit> {
    let (states, constants, modes) = (table.states.len(), table.constants.count, table.modes.len());
    if states > room.0 {
        Err(DoesNotFit::States(states))
    } else if constants > room.1 || table.parameters.len() > room.1 {
        Err(DoesNotFit::Constants(constants.max(table.parameters.len())))
    } else if modes > MAX_MODES {
        Err(DoesNotFit::Modes(modes))
    } else {
        Ok(())
    }
}
