//! What each function of a model is called, from where the table uses it.

use equations::table::{ContactModeTable, FunctionId, GuardTable, ModeTable, ModelTable};

use super::names::{Identifiers, plain};

/// The longest name of a function.
const LONGEST: usize = 34;

/// What a function is for.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct FunctionPurpose {
    /// Its name in the emitted code.
    pub(super) name: String,
    /// The sentence that stands above it.
    pub(super) doc: String,
}

/// Returns the purpose of each of `count` functions.
pub(super) fn purposes(table: &ModelTable, count: usize) -> Vec<FunctionPurpose> {
    let mut all = FunctionPurposes { found: vec![None; count] };
    all.of_model(table);
    for mode in table.modes {
        all.of_mode(mode);
    }
    let mut taken = Identifiers::new();
    let name = |(at, found): (usize, Option<FunctionPurpose>)| {
        let FunctionPurpose { name, doc } = found.unwrap_or_else(|| FunctionPurpose {
            name: format!("function_{at}"),
            doc: "Is not used by the table.".to_owned(),
        });
        FunctionPurpose { name: taken.take_long(&name.to_lowercase(), LONGEST), doc }
    };
    all.found.into_iter().enumerate().map(name).collect()
}

struct FunctionPurposes {
    found: Vec<Option<FunctionPurpose>>,
}

impl FunctionPurposes {
    /// The first use of a function names it.
    fn set(&mut self, function: impl Into<Option<FunctionId>>, name: &str, doc: &str) {
        let Some(function) = function.into() else { return };
        if let Some(place @ None) = self.found.get_mut(usize::from(function)) {
            *place = Some(FunctionPurpose { name: name.to_owned(), doc: doc.to_owned() });
        }
    }

    fn of_model(&mut self, table: &ModelTable) {
        self.set(table.derive_constants, "derived_constants", "What follows from the parameters.");
        self.set(table.input_per_metre, "input_per_metre", "Input per metre of key-front travel.");
        self.set(table.rest.state, "rest", "The state to start from.");
        for (at, (when, _)) in table.rest.instead.iter().enumerate() {
            let doc = "Is positive where it rests in another mode.";
            self.set(*when, &format!("rest_when_{at}"), doc);
        }
        if table.drawing.count > 0 {
            self.set(table.drawing.numbers, "drawing", "The numbers of the drawing.");
        }
        for preset in table.presets {
            let (name, title) = (plain(preset.name, LONGEST), plain(preset.name, LONGEST));
            self.set(preset.values, &format!("preset_{name}"), &format!("The preset {title}."));
        }
        for (at, requirement) in table.requirements.iter().enumerate() {
            let doc = "Is positive where a condition on the parameters is met.";
            self.set(requirement.margin, &format!("requirement_{at}"), doc);
        }
    }

    fn of_mode(&mut self, mode: &ModeTable) {
        let name = plain(mode.name, LONGEST / 2);
        let mut set = |function: Option<FunctionId>, what: &str, doc: &str| {
            self.set(function, &format!("{what}_{name}"), &format!("{doc} in mode {name}."));
        };
        set(Some(mode.derivative), "derivative", "The derivative of the state");
        set(mode.slaved, "slaved", "The state with slaved entries in place");
        set(mode.projection, "projection", "A Newton step towards the constraints");
        set(Some(mode.readout), "readout", "The readout");
        set(Some(mode.slopes), "slopes", "The readout's slopes");
        set(Some(mode.outputs), "outputs", "The outputs");
        set(Some(mode.balance), "balance", "Energy, supplied and dissipated power");
        set(Some(mode.jacobian), "jacobian", "The derivative's derivative by the state");
        set(mode.series.map(|it| it.start), "series_start", "Where the Taylor series begins");
        set(mode.series.map(|it| it.step), "series_step", "One order of the Taylor series");
        for (at, part) in mode.parts.iter().enumerate() {
            set(Some(part.derivative), &format!("part_{at}"), "The derivative of a part");
        }
        for guard in mode.guards {
            self.of_guard(guard, &name);
        }
        for contact in mode.contacts {
            self.of_contact(contact, &name);
        }
    }

    fn of_guard(&mut self, guard: &GuardTable, mode: &str) {
        let name = plain(guard.name, LONGEST / 2);
        let mut set = |function: Option<FunctionId>, what: &str, doc: &str| {
            let doc = format!("{doc} {name} in mode {mode}.");
            self.set(function, &format!("{what}_{name}_{mode}"), &doc);
        };
        set(Some(guard.value), "guard", "The guard and its rate:");
        set(guard.bound, "bound", "Bounds of the guard's move and bend:");
        set(guard.sounds, "speed", "The speed of what strikes at guard");
        for (at, way) in guard.ways.iter().enumerate() {
            set(way.when, &format!("when_{at}"), "Is positive where a way is taken from guard");
            set(way.reset, &format!("reset_{at}"), "The state after guard");
        }
    }

    fn of_contact(&mut self, contact: &ContactModeTable, mode: &str) {
        let number = contact.contact;
        let mut set = |function: Option<FunctionId>, what: &str, doc: &str| {
            let doc = format!("{doc} contact {number} in mode {mode}.");
            self.set(function, &format!("{what}_{number}_{mode}"), &doc);
        };
        set(contact.gap, "gap", "The gap and its rate:");
        set(contact.bound, "gap_bound", "Bounds of the gap's move and bend:");
        set(contact.normal, "normal", "What is added to the derivative by the closed");
        set(
            contact.balance,
            "contact_balance",
            "What is added to readout and powers by the closed",
        );
        set(contact.slip, "slip", "The slip, its rate by time alone and its gradient:");
        set(contact.slip_bound, "slip_bound", "Bounds of the slip's move and bend:");
        set(
            contact.slopes,
            "contact_slopes",
            "What is added to the readout's slopes by the closed",
        );
        set(contact.limits, "limits", "Stiction and kinetic friction:");
        set(contact.response, "response", "What 1 N of friction adds at");
        set(contact.sounds, "contact_speed", "The speed of what strikes at");
    }
}
