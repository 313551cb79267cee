//! Impossible configurations of rigid contacts, with constraints that depend on one another.

use super::error::{DerivationError, DerivationObstacle};
use crate::kane::mechanism::{Guard, GuardBranch, Mechanism};

/// Returns the configurations without equations only by dependent constraints; `None` otherwise.
pub(super) fn dependent(mechanism: &Mechanism, errors: &[DerivationError]) -> Option<Vec<usize>> {
    let one = |error: &DerivationError| {
        let mode = error.mode?;
        let is_dependent =
            matches!(error.obstacle, DerivationObstacle::DependentConstraints { .. });
        (is_dependent && mechanism.modes.get(mode)?.is_configuration).then_some(mode)
    };
    errors.iter().map(one).collect()
}

/// Removes modes and records their names. A contact cannot close into a removed mode: in the mode
/// before, its gap stays as it is.
pub(super) fn leave_out(mechanism: &mut Mechanism, gone: &[usize]) {
    let mut next = 0;
    let mut numbers = Vec::new();
    for (number, mode) in mechanism.modes.iter().enumerate() {
        if gone.contains(&number) {
            mechanism.instrument.left_out.push(mode.name.clone());
            numbers.push(None);
        } else {
            numbers.push(Some(next));
            next += 1;
        }
    }
    keep(&mut mechanism.modes, gone);
    let now = |mode: usize| numbers.get(mode).copied().flatten();
    for mode in &mut mechanism.modes {
        mode.guards =
            std::mem::take(&mut mode.guards).into_iter().filter_map(|it| led(it, &now)).collect();
    }
    for family in &mut mechanism.instrument.impacts.families {
        let members = family.members.iter().filter_map(|(mode, bits)| Some((now(*mode)?, *bits)));
        family.members = members.collect();
    }
    for output in &mut mechanism.outputs {
        keep(&mut output.values, gone);
    }
    let drawing = &mut mechanism.instrument.drawing;
    for frame in &mut drawing.frames {
        keep(&mut frame.frames, gone);
    }
    let outlines = drawing.bodies.iter_mut().flat_map(|body| &mut body.outlines);
    let shown = outlines.map(|it| &mut it.modes);
    for modes in shown.chain(drawing.springs.iter_mut().map(|it| &mut it.modes)) {
        *modes = modes.iter().filter_map(|mode| now(*mode)).collect();
    }
}

fn keep<T>(all: &mut Vec<T>, gone: &[usize]) {
    let mut index = 0;
    all.retain(|_| {
        index += 1;
        !gone.contains(&(index - 1))
    });
}

/// Returns a guard with the new numbers of modes; `None` if its target was removed.
fn led(guard: Guard, now: &impl Fn(usize) -> Option<usize>) -> Option<Guard> {
    let branches = guard.branches.into_iter().map(|it| led_branch(it, now));
    Some(Guard { branches: branches.collect::<Option<_>>()?, ..guard })
}

fn led_branch(branch: GuardBranch, now: &impl Fn(usize) -> Option<usize>) -> Option<GuardBranch> {
    let to = now(branch.to)?;
    let mut impact = branch.impact;
    if let Some(impact) = &mut impact {
        for mode in [&mut impact.within, &mut impact.settles] {
            if let Some(old) = mode {
                *mode = Some(now(*old)?);
            }
        }
    }
    Some(GuardBranch { to, impact, ..branch })
}
