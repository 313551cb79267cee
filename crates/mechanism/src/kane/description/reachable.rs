use documents::quoted;

use super::reader::MechanismReader;

impl MechanismReader {
    pub(super) fn check_modes(&mut self) {
        // A branch that was not understood may be the missing one.
        if !self.exits.are_whole || self.mechanism.modes.len() < 2 {
            return;
        }
        let reached = self.reached_modes();
        for (index, is_reached) in reached.into_iter().enumerate() {
            let Some((name, place)) = self.modes.get(index).cloned() else { continue };
            if !is_reached {
                let message = format!("the mode {} is unreachable", quoted(&name));
                let help = "lead a guard to it, or make it the mode of [rest]";
                self.report.say(place, message, help);
            }
            let has_exit = self.mechanism.modes.get(index).is_some_and(|it| {
                let mut ways = it.guards.iter().flat_map(|guard| &guard.branches);
                ways.any(|way| way.to != index || way.impact.is_some_and(|it| it.settles.is_some()))
            });
            if !has_exit && !self.exits.lasting.contains(&index) {
                let message = format!("the mode {} has no exit", quoted(&name));
                let help = "give it a guard that leads elsewhere; if it is meant to last, write final = true";
                self.report.say(place, message, help);
            }
        }
    }

    fn reached_modes(&self) -> Vec<bool> {
        let rest = &self.mechanism.rest;
        let mut open: Vec<usize> = rest.instead.iter().map(|(_, mode)| *mode).collect();
        open.push(rest.mode);
        let mut reached = vec![false; self.mechanism.modes.len()];
        while let Some(index) = open.pop() {
            let Some(slot) = reached.get_mut(index).filter(|it| !**it) else { continue };
            *slot = true;
            let guards = self.mechanism.modes.get(index).map_or(&[][..], |it| &it.guards);
            for way in guards.iter().flat_map(|it| &it.branches) {
                open.push(way.to);
                open.extend(way.impact.and_then(|it| it.settles));
            }
        }
        reached
    }
}
