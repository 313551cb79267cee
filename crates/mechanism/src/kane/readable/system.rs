use instruments::equations::table::is_pose;

use super::writer::{Equation, equations};
use super::{Notation, SymbolNames};
use crate::kane::graph::{Graph, Node, NodeOperation, Place};
use crate::kane::system::{EquationSystem, GuardEquations, ModeEquations, Way};

/// Returns the equations of `system` by mode: slaved entries, rates, outputs, guards, reset maps.
pub fn system_equations(system: &EquationSystem, notation: Notation) -> String {
    let mut text = String::new();
    for mode in 0..system.modes.len() {
        text.push_str(&mode_equations(system, mode, notation));
        text.push('\n');
    }
    for name in &system.mechanism.instrument.left_out {
        text.push_str("no mode ");
        text.push_str(name);
        text.push_str(": its constraints depend on one another\n");
    }
    text
}

/// Returns the equations of one mode of `system`; an empty text for an unknown mode.
pub fn mode_equations(system: &EquationSystem, mode: usize, notation: Notation) -> String {
    let Some(found) = system.modes.get(mode) else { return String::new() };
    let names = SymbolNames::of(&system.mechanism);
    let graph = system.mechanism.graph.clone();
    let mut page = Page {
        system,
        graph,
        names,
        wanted: Vec::new(),
        sections: Vec::new(),
        statements: Vec::new(),
    };
    page.motion(found);
    page.results(found);
    for guard in &found.guards {
        page.guard(guard);
    }
    let title = system.mechanism.modes.get(mode).map_or("", |it| it.name.as_str());
    page.print(title, notation)
}

struct Page<'a> {
    system: &'a EquationSystem,
    /// The system's, and terms that are only printed.
    graph: Graph,
    names: SymbolNames,
    wanted: Vec<(String, Node)>,
    sections: Vec<(usize, String)>,
    /// Statements without an equation, each with the number of sections before it.
    statements: Vec<(usize, String)>,
}

impl Page<'_> {
    fn section(&mut self, heading: String) {
        self.sections.push((self.wanted.len(), heading));
    }

    fn want(&mut self, name: impl Into<String>, node: impl Into<Option<Node>>) {
        self.wanted.extend(node.into().map(|node| (name.into(), node)));
    }

    /// Adds a rate, unless it is a speed of that name: `y' = y'` is empty.
    fn want_rate(&mut self, name: &str, node: Option<Node>) {
        let Some(node) = node else { return };
        let operation = self.graph.operation(node);
        let is_said =
            matches!(operation, NodeOperation::Symbol(it) if self.names.name(*it) == name);
        if !is_said {
            self.want(name, node);
        }
    }

    fn is_itself(&self, node: Node, place: Place) -> bool {
        matches!(self.graph.operation(node), NodeOperation::Symbol(it) if *it == place)
    }

    fn motion(&mut self, mode: &ModeEquations) {
        self.section("motion".to_owned());
        for (at, place) in self.system.state.iter().enumerate() {
            let name = self.names.name(*place);
            if mode.is_free.get(at) == Some(&false) {
                let is_said = self.wanted.iter().any(|(said, _)| *said == name);
                self.want(name, mode.slaved.get(at).copied().filter(|_| !is_said));
            } else {
                let rate = mode.derivative.get(at).map(|rate| self.with_contacts(mode, at, *rate));
                self.want_rate(&format!("{name}'"), rate);
            }
        }
        for contact in &mode.contacts {
            let name = self.system.mechanism.contacts.get(contact.contact);
            let name = name.map_or("", |it| it.name.as_str()).to_owned();
            self.section(format!("contact {name}"));
            self.want(format!("gap({name})"), contact.gap.map(|it| it[0]));
            self.want(format!("force({name})"), contact.normal.map(|it| it[0]));
            if let Some(friction) = &contact.friction {
                self.want(format!("slip({name})"), friction.slip);
                self.want(format!("stiction({name})"), friction.stiction);
                self.want(format!("kinetic({name})"), friction.kinetic);
            }
        }
    }

    /// Returns a rate with what contacts and frictions add to it, by their names.
    fn with_contacts(&mut self, mode: &ModeEquations, entry: usize, rate: Node) -> Node {
        let mut terms = vec![(rate, 1.0)];
        let responses = mode.contacts.iter().flat_map(|contact| {
            let number = u16::try_from(contact.contact).unwrap_or(u16::MAX);
            let normal = contact.normal.map(|_| (Place::Contact(number), &contact.normal_response));
            let friction = contact.friction.as_ref();
            [normal, friction.map(|it| (Place::Friction(number), &it.response))]
        });
        for (place, per) in responses.flatten() {
            let force = self.graph.symbol(place);
            let per = per.derivative.get(entry);
            terms.extend(per.map(|per| (self.graph.multiply(*per, force), 1.0)));
        }
        self.graph.sum(&terms)
    }

    fn say(&mut self, statement: String) {
        self.statements.push((self.sections.len(), statement));
    }

    /// Returns the mode in which the rebounds of an impact end, if it is another one.
    fn settled(&self, way: &Way) -> Option<String> {
        let mode = way.branch.impact?.settles.filter(|to| *to != way.branch.to)?;
        Some(self.system.mechanism.modes.get(mode)?.name.clone())
    }

    fn results(&mut self, mode: &ModeEquations) {
        self.section("readout, energy (J) and power (W)".to_owned());
        self.want("readout", mode.readout);
        self.want("energy", mode.balance.energy);
        self.want("supplied", mode.balance.supplied);
        self.want("dissipated", mode.balance.dissipated);
        self.section("outputs".to_owned());
        let outputs = self.system.mechanism.outputs.iter().zip(&mode.outputs);
        for (output, node) in outputs.filter(|(output, _)| !is_pose(&output.name)) {
            self.want(output.name.clone(), *node);
        }
    }

    fn guard(&mut self, guard: &GuardEquations) {
        self.section(format!("guard {}, positive while the mode is valid", guard.name));
        self.want(guard.name.clone(), guard.value);
        self.want(format!("{}'", guard.name), guard.rate);
        for way in &guard.ways {
            let to = self.system.mechanism.modes.get(way.branch.to);
            let to = to.map_or("", |it| it.name.as_str());
            let where_to = way.branch.when.map_or("", |_| " where `when` is positive");
            if guard.closes.is_some() {
                let name = &guard.name;
                self.say(format!(
                    "{name} closes: the law of impacts gives speeds and the next mode"
                ));
                continue;
            }
            let heading = format!("{} leads to {to}{where_to}; after it", guard.name);
            self.section(heading.clone());
            let before = self.wanted.len();
            self.want("when", way.branch.when);
            for (place, node) in self.system.state.iter().zip(&way.state) {
                let changed = (!self.is_itself(*node, *place)).then_some(*node);
                self.want(self.names.name(*place), changed);
            }
            if self.wanted.len() == before {
                self.say(format!("{heading} all is as before"));
            }
            if let Some(settled) = self.settled(way) {
                self.say(format!("{} leads to {settled} where its rebounds end", guard.name));
            }
        }
        self.want("sounds", guard.sounds);
    }

    fn print(&self, title: &str, notation: Notation) -> String {
        let graph = &self.graph;
        let (definitions, lines) = equations(graph, &self.wanted, &self.names, notation);
        let mut printed = Printed { notation, text: String::new() };
        printed.title(&format!("mode {title}"));
        printed.block("where", &definitions);
        for (at, (from, heading)) in self.sections.iter().enumerate() {
            let to = self.sections.get(at + 1).map_or(lines.len(), |it| it.0);
            printed.block(heading, lines.get(*from..to).unwrap_or_default());
            for (_, statement) in self.statements.iter().filter(|it| it.0 == at + 1) {
                printed.statement(statement);
            }
        }
        printed.text
    }
}

struct Printed {
    notation: Notation,
    text: String,
}

impl Printed {
    fn title(&mut self, title: &str) {
        let title = match self.notation {
            Notation::Text => format!("{title}\n{}\n", "=".repeat(title.chars().count())),
            Notation::Latex => format!("\\section*{{{}}}\n", super::words::escaped(title)),
        };
        self.text.push_str(&title);
    }

    fn statement(&mut self, text: &str) {
        let text = match self.notation {
            Notation::Text => format!("\n{text}\n"),
            Notation::Latex => format!("\\paragraph{{{}}}\n", super::words::escaped(text)),
        };
        self.text.push_str(&text);
    }

    fn block(&mut self, heading: &str, lines: &[Equation]) {
        if lines.is_empty() {
            return;
        }
        let (open, close) = match self.notation {
            Notation::Text => (format!("\n{heading}:\n"), ""),
            Notation::Latex => {
                let heading = super::words::escaped(heading);
                (format!("\\paragraph{{{heading}}}\n\\begin{{align*}}\n"), "\\end{align*}\n")
            }
        };
        self.text.push_str(&open);
        for line in lines {
            let line = match self.notation {
                Notation::Text => format!("    {} = {}\n", line.left, line.right),
                Notation::Latex => format!("{} &= {} \\\\\n", line.left, line.right),
            };
            self.text.push_str(&line);
        }
        self.text.push_str(close);
    }
}
