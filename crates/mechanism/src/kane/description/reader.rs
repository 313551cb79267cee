//! The reading of one description, from its text to the mechanism.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "TOML has many kinds of values, and each place takes few of them"
)]

use documents::toml::{
    FindingList, KeyReader, SourcePlace, TomlEntry, TomlKind, TomlNode, TomlSource,
};
use documents::{Diagnostics, choice, quoted};

use super::bases::{self, Bases};
use super::configurations::FamilyNames;
use super::items::{DescribedItem, FileExpression, FrictionText, ParameterText, PlausibleValues};
use super::names::NameTable;
use super::{Description, MOST_COORDINATES, MOST_OF_A_KIND};
use super::{rigid, time};
use crate::kane::graph::{Graph, Node, Substitution};
use crate::kane::mechanism::{
    Constraint, ContactFamily, DrawnFrame, Force, Guard, ImpactLaw, Mechanism, MechanismContact,
};
use crate::kane::text::{Dependence, Measured};

/// Most operands that all expressions of a description may have.
const HEAVIEST: usize = 100_000;

const LAWS: [(&str, ImpactLaw); 3] = [
    ("newton", ImpactLaw::Newton),
    ("poisson", ImpactLaw::Poisson),
    ("sequential", ImpactLaw::Sequential),
];

/// What laws and requirements are over.
pub(super) const CONSTANT: Dependence = Dependence::PARAMETERS;
/// What places are over.
pub(super) const POSE: Dependence =
    Dependence::PARAMETERS.and(Dependence::COORDINATES).and(Dependence::INPUT);
/// What forces are over.
pub(super) const STATE: Dependence = POSE.and(Dependence::SPEEDS).and(Dependence::INPUT_RATES);
/// What guards are over.
pub(super) const MOTION: Dependence =
    STATE.and(Dependence::ACCELERATIONS).and(Dependence::REACTIONS).and(Dependence::FORCES);
/// What outputs are over.
pub(super) const RESULT: Dependence = MOTION.and(Dependence::FRICTIONS);

#[derive(Clone, PartialEq, Debug)]
pub(super) struct WatchedNode {
    pub(super) node: Node,
    pub(super) place: SourcePlace,
    pub(super) text: String,
    pub(super) reach: Dependence,
    pub(super) mode: Option<usize>,
}

#[derive(Debug, Default)]
pub(super) struct MechanismReader {
    pub(super) report: FindingList,
    pub(super) graph: Graph,
    pub(super) names: NameTable,
    pub(super) mechanism: Mechanism,
    pub(super) items: Vec<DescribedItem>,
    pub(super) parameters: Vec<ParameterText>,
    /// Tensions of forces by name, in each mode; the last is with all of them.
    pub(super) forces_in_modes: Vec<Substitution>,
    pub(super) watched: Vec<WatchedNode>,
    pub(super) modes: Vec<(String, SourcePlace)>,
    pub(super) exits: ModeExits,
    pub(super) places: ItemPlaces,
    pub(super) point_places: Vec<Option<(usize, [Node; 3])>>,
    pub(super) drawn_frames: Vec<DrawnFrame>,
    pub(super) built: BuiltLaws,
    pub(super) size: DescriptionSize,
}

#[derive(Debug, Default)]
pub(super) struct ModeExits {
    pub(super) are_whole: bool,
    pub(super) has_lost: bool,
    pub(super) lasting: Vec<usize>,
}

/// Where values stand in the file that are checked when all is read.
#[derive(Debug, Default)]
pub(super) struct ItemPlaces {
    pub(super) rest: SourcePlace,
    pub(super) rest_coordinates: Vec<Option<SourcePlace>>,
    pub(super) presets: Vec<Vec<SourcePlace>>,
    pub(super) requirements: Vec<SourcePlace>,
}

/// The laws that were built, each with its number in the order of the file.
#[derive(Debug, Default)]
pub(super) struct BuiltLaws {
    pub(super) constraints: Vec<(usize, Constraint)>,
    pub(super) forces: Vec<(usize, Force)>,
    pub(super) contacts: Vec<(usize, MechanismContact)>,
    /// Typical sizes of gaps (m).
    pub(super) contact_scales: Vec<(usize, f64)>,
    pub(super) frictions: Vec<FrictionText>,
    pub(super) plausible: PlausibleValues,
}

#[derive(Debug, Default)]
pub(super) struct DescriptionSize {
    pub(super) expressions: usize,
    weight: usize,
    /// Nodes of the graph that are counted in `weight`.
    weighed: usize,
    pub(super) is_full: bool,
}

impl MechanismReader {
    pub(super) fn read(
        mut self,
        source: TomlSource,
        bases: &dyn Bases,
    ) -> Result<Description, Diagnostics> {
        self.graph.limit_work();
        let mut doc = String::new();
        if let Some(tree) = bases::merged(&mut self.report, source, bases) {
            let (tree, families) =
                rigid::written_out(&mut self.report, &tree).unwrap_or((tree, Vec::new()));
            let tree = time::with_time(&tree).unwrap_or(tree);
            self.names.is_broken = self.report.is_broken;
            doc = self.all(&tree);
            self.families(&families);
        }
        if let Some(end) = self.graph.given_up() {
            self.report.replace(bases::start(0), end.to_string(), "describe a smaller model");
        }
        let mechanism = Mechanism { graph: self.graph, ..self.mechanism };
        let sources = self.report.texts();
        self.report.verdict(Some(Description { mechanism, doc, sources }))
    }

    /// Reads a whole tree; returns the paragraphs about it.
    fn all(&mut self, tree: &TomlNode) -> String {
        let Some(mut root) = KeyReader::of(&mut self.report, "description", tree) else {
            return String::new();
        };
        let doc = self.heading(&mut root);
        if self.has_too_many(tree) {
            return doc;
        }
        self.declare(&mut root);
        self.resolve();
        self.bodies(&mut root);
        let before = self.report.len();
        self.modes(&mut root);
        self.rest(&mut root);
        self.exits.are_whole =
            self.report.len() == before && !self.report.is_broken && !self.exits.has_lost;
        self.outputs(&mut root);
        self.damper(&mut root);
        self.midi(&mut root);
        self.drawing(&mut root);
        root.finish(&mut self.report);
        self.check();
        doc
    }

    fn heading(&mut self, root: &mut KeyReader<'_>) -> String {
        match root.text(&mut self.report, "name") {
            Some((name, place)) => {
                let is_plain = |it: char| it.is_ascii_alphanumeric() || "-_".contains(it);
                if name.is_empty() || !name.chars().all(is_plain) {
                    let message = format!("{} is no name", quoted(name));
                    self.report.say(place, message, "use letters, digits, - and _");
                }
                name.clone_into(&mut self.mechanism.name);
            }
            None if root.take("name").is_none() => {
                let help = "write name = \"my-action\" in the first line";
                self.report.miss(bases::start(0), "the description has no name", help);
            }
            None => {}
        }
        if let Some((summary, _)) = root.text(&mut self.report, "summary") {
            summary.clone_into(&mut self.mechanism.instrument.summary);
        }
        if let Some((law, place)) = root.text(&mut self.report, "impacts") {
            let found = LAWS.iter().find(|(name, _)| *name == law);
            if found.is_none() {
                let message = format!("there is no impact law {}", quoted(law));
                self.report.say(place, message, choice(law, LAWS.map(|it| it.0)));
            }
            self.mechanism.instrument.impacts.law = found.map(|it| it.1).unwrap_or_default();
        }
        root.text(&mut self.report, "doc").map(|(doc, _)| doc.trim().to_owned()).unwrap_or_default()
    }

    /// Gives the guards that close contacts of a family to the law of its impacts.
    fn families(&mut self, all: &[FamilyNames]) {
        for family in all {
            let known = |name: &String| self.modes.iter().position(|(mode, _)| mode == name);
            let members = family.members.iter().map(|(name, bits)| Some((known(name)?, *bits)));
            let Some(members) = members.collect::<Option<Vec<_>>>() else { continue };
            let contacts = family.contacts.iter().map(|name| {
                let guards = &self.mechanism.modes.get(members.first()?.0)?.guards;
                let impact = guards.iter().find(|it| it.name == *name)?.branches.first()?.impact?;
                Some((self.names.constraints.index(name)?, impact.restitution))
            });
            let Some(contacts) = contacts.collect::<Option<Vec<_>>>() else { continue };
            let modes = self.mechanism.modes.iter_mut().enumerate();
            let own = modes.filter(|(number, _)| members.iter().any(|it| it.0 == *number));
            for (_, mode) in own {
                close_by_law(&mut mode.guards, &family.contacts);
            }
            self.mechanism.instrument.impacts.families.push(ContactFamily { members, contacts });
        }
    }

    fn has_too_many(&mut self, tree: &TomlNode) -> bool {
        let mut is_too_many = false;
        for entry in tree.entries().unwrap_or(&[]) {
            let count = match &entry.node.kind {
                TomlKind::Table(entries) => entries.len(),
                TomlKind::List(items) => items.len(),
                _ => 0,
            };
            let is_motion = matches!(entry.name.as_str(), "coordinates" | "speeds");
            let most = if is_motion { MOST_COORDINATES } else { MOST_OF_A_KIND };
            if count > most {
                let message = format!("{} has {count} entries", quoted(&entry.name));
                let help = format!("there are {most} at most");
                self.report.say(entry.place, message, help);
                is_too_many = true;
            }
        }
        is_too_many
    }

    pub(super) fn watch(&mut self, file: &FileExpression, value: Measured, mode: Option<usize>) {
        let Measured { node, reach, .. } = value;
        let text = file.expression.text.clone();
        self.watched.push(WatchedNode { node, place: file.place, text, reach, mode });
    }

    pub(super) fn weigh(&mut self, place: SourcePlace) {
        let mut count = 0;
        for node in self.graph.nodes_from(self.size.weighed) {
            count += 1;
            self.graph.operation(node).operands(|_| count += 1);
        }
        self.size.weighed = self.graph.len();
        self.size.weight += count;
        if self.size.weight > HEAVIEST {
            self.fill(place, "the expressions are too large together");
        }
    }

    pub(super) fn fill(&mut self, place: SourcePlace, message: &str) {
        if !self.size.is_full {
            self.report.say(place, message, "make the description smaller");
        }
        self.size.is_full = true;
    }

    pub(super) fn twice(&mut self, entry: &TomlEntry, first: SourcePlace) {
        let there = self.report.describe(first, entry.place);
        let message = format!("{} is a name already (at {there})", quoted(&entry.name));
        self.report.say(entry.place, message, "give one of the two another name");
    }

    /// Whether `entry` has a name that expressions can use; reports one that has not.
    pub(super) fn is_name(&mut self, entry: &TomlEntry) -> bool {
        let name = entry.name.as_str();
        let starts = name.starts_with(|it: char| it.is_alphabetic() || it == '_');
        let goes_on =
            name.chars().all(|it| (it.is_alphanumeric() && !"²³".contains(it)) || it == '_');
        let is_free = !matches!(name, "pi" | "key" | "if");
        if starts && goes_on && is_free {
            return true;
        }
        let message = format!("{} cannot be a name", quoted(name));
        let help = "use letters, digits and _, a letter first; pi, key and if are taken";
        self.report.say(entry.place, message, help);
        false
    }
}

fn close_by_law(guards: &mut [Guard], contacts: &[String]) {
    for guard in guards {
        guard.closes = (0..).zip(contacts).find(|(_, it)| **it == guard.name).map(|it| it.0);
        if let Some(branch) = guard.closes.and(guard.branches.first_mut()) {
            branch.impact = None;
        }
    }
}
