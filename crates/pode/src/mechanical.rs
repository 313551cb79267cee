//! Equations of a mode in mechanical form: M(q) u' = Q(q, u, z), with slopes of the forces.

/// Maximum number of generalised speeds of a mechanical form.
pub const MAX_SPEEDS: usize = 8;

/// Maximum number of internal states, such as the wound-up displacement of a friction.
pub const MAX_INTERNAL: usize = 8;

/// Maximum number of non-zero entries of all stiffness rows.
pub const MAX_SLOPES: usize = 96;

/// Maximum number of entries of a state.
const MAX_ENTRIES: usize = 64;

const ROOM: usize = MAX_INTERNAL + MAX_SPEEDS + 3 * packed(MAX_SPEEDS) + MAX_SLOPES;

/// Returns the number of entries of a lower triangle of `n` rows.
const fn packed(n: usize) -> usize {
    n * (n + 1) / 2
}

/// A square matrix with the rows of a mode's speeds in its first entries.
pub type SpeedMatrix = [[f64; MAX_SPEEDS]; MAX_SPEEDS];

/// Role of a state's entry in a mechanical form; the numbers count speeds and internal states.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EntryRole {
    /// Coordinate with the rate of this speed.
    Coordinate(u8),
    Speed(u8),
    Internal(u8),
    /// Set by the mode's constraints.
    Slaved,
}

/// Sizes of a mode's mechanical form, and the roles of its entries.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MechanicalLayout {
    pub roles: [EntryRole; MAX_ENTRIES],
    /// Numbers of the entries that are the speeds.
    pub entries: [u8; MAX_SPEEDS],
    pub speeds: usize,
    pub internal: usize,
    /// Element and speed of each non-zero entry of the stiffness rows, element by element.
    pub slopes: [(u8, u8); MAX_SLOPES],
    pub slope_count: usize,
}

impl MechanicalLayout {
    /// A form without speeds.
    pub const EMPTY: Self = Self {
        roles: [EntryRole::Slaved; MAX_ENTRIES],
        entries: [0; MAX_SPEEDS],
        speeds: 0,
        internal: 0,
        slopes: [(0, 0); MAX_SLOPES],
        slope_count: 0,
    };

    /// Maximum number of values of a contact: those that it adds, and its stiffness row.
    pub const MAX_ADDED: usize = 2 * MAX_SPEEDS + 2 * packed(MAX_SPEEDS);

    /// Returns the number of values that a contact adds: forces, stiffness and damping.
    pub const fn added(&self) -> usize {
        self.speeds + 2 * packed(self.speeds)
    }

    /// Returns the index of the first value that a contact adds.
    pub const fn first_added(&self) -> usize {
        self.internal + packed(self.speeds)
    }

    /// Returns `true` if the sizes are within their limits.
    pub const fn fits(&self) -> bool {
        self.speeds <= MAX_SPEEDS && self.internal <= MAX_INTERNAL && self.slope_count <= MAX_SLOPES
    }
}

/// A point at which a mechanical form is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct MechanicalPoint<'a, S> {
    /// Coordinates and speeds at the end of the step, internal states at its start.
    pub state: &'a S,
    /// Length of the step (s).
    pub h: f64,
    /// Speeds in the middle of the step, which move the internal states.
    pub middle: [f64; MAX_SPEEDS],
}

/// Values of a mechanical form.
///
/// In this order, triangles by rows: internal states at the step's end, the lower triangle of M, the
/// forces Q, the lower triangles of stiffness and damping, and the stiffness rows ∂f/∂q of the
/// elements.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MechanicalValues {
    pub numbers: [f64; ROOM],
    /// Sum of the magnitudes of the closed contacts' stiffness rows; `None` if all are open.
    pub contacts: Option<[f64; MAX_SPEEDS]>,
}

impl MechanicalValues {
    pub const ZERO: Self = Self { numbers: [0.0; ROOM], contacts: None };

    #[inline]
    fn from(&self, first: usize) -> &[f64] {
        self.numbers.get(first..).unwrap_or_default()
    }

    /// Adds the values of a closed contact: forces, stiffness and damping, then its stiffness row.
    #[inline]
    pub fn add_contact(&mut self, layout: &MechanicalLayout, added: &[f64]) {
        let own = self.numbers.iter_mut().skip(layout.first_added());
        for (value, more) in own.zip(added).take(layout.added()) {
            *value += more;
        }
        let row = added.iter().skip(layout.added()).take(layout.speeds);
        let sums = self.contacts.get_or_insert([0.0; MAX_SPEEDS]);
        for (sum, slope) in sums.iter_mut().zip(row) {
            *sum += slope.abs();
        }
    }

    /// Returns the internal states at the end of the step.
    #[inline]
    pub fn internal(&self) -> &[f64] {
        &self.numbers
    }

    /// Returns Q.
    #[inline]
    pub fn forces(&self, layout: &MechanicalLayout) -> &[f64] {
        self.from(layout.first_added())
    }

    /// Returns the entries of the stiffness rows, as listed in the layout.
    #[inline]
    pub fn slopes(&self, layout: &MechanicalLayout) -> &[f64] {
        self.from(layout.first_added() + layout.added())
    }

    /// Returns M `a`.
    #[inline]
    pub fn momentum(&self, layout: &MechanicalLayout, a: &[f64; MAX_SPEEDS]) -> [f64; MAX_SPEEDS] {
        let n = layout.speeds.min(MAX_SPEEDS);
        let mut mass = self.from(layout.internal).iter();
        let mut all = [0.0; MAX_SPEEDS];
        for row in 0..n {
            for (column, mass) in (0..row).zip(&mut mass) {
                all[row] += mass * a[column];
                all[column] += mass * a[row];
            }
            all[row] += mass.next().map_or(0.0, |mass| mass * a[row]);
        }
        all
    }

    /// Returns M + `damping` D + `stiffness` K, the lower triangle.
    #[inline]
    pub fn matrix(&self, layout: &MechanicalLayout, damping: f64, stiffness: f64) -> SpeedMatrix {
        let n = layout.speeds.min(MAX_SPEEDS);
        let mass = self.from(layout.internal);
        let k = self.from(layout.first_added() + n);
        let d = self.from(layout.first_added() + n + packed(n));
        let mut entries = mass.iter().zip(k).zip(d);
        let mut matrix = [[0.0; MAX_SPEEDS]; MAX_SPEEDS];
        for (row, line) in matrix.iter_mut().enumerate().take(n) {
            for (entry, ((mass, k), d)) in line.iter_mut().take(row + 1).zip(&mut entries) {
                *entry = mass + damping * d + stiffness * k;
            }
        }
        matrix
    }
}

/// A model with modes in mechanical form.
pub trait Mechanical<M, S, I> {
    /// Returns the layout of `mode`; `None` without a mechanical form.
    fn layout(&self, mode: M) -> Option<&MechanicalLayout>;

    /// Evaluates the form of `mode` at `point`.
    ///
    /// # Real-time
    /// Bounded: one function of the mode, and one of each closed contact.
    fn evaluate(
        &self,
        mode: M,
        point: &MechanicalPoint<'_, S>,
        input: &I,
        out: &mut MechanicalValues,
    );
}
