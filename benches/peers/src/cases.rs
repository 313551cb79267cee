//! The problems, each with its reference and its entries.

use pode::{Motion, Resets};

use crate::entry::Entry;
use crate::peers;
use crate::peers::{Ours, Written, shipped};
use crate::problem::Problem;
use crate::problems::{Ball, Block, BlockMode, Cradle};
use crate::reference::{self, ModelBCase, Reference};

pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) summary: &'static str,
    pub(crate) t_end: f64,
    pub(crate) reference: Reference,
    pub(crate) entries: Vec<Entry>,
    /// Parameters as `name value` lines, for the other programs.
    pub(crate) parameters: String,
}

pub(crate) fn all() -> Result<Vec<Case>, String> {
    Ok(vec![
        model_b(
            "figure-6",
            "model-b-figure6",
            "model B under a stroke: release, catch, throw, string, landing, bounces",
        )?,
        ball(),
        model_b(
            "stiff-10",
            "model-b-stiff-10",
            "the same stroke with both springs ten times stiffer",
        )?,
        cradle("cradle-1", "a cradle of five balls with small gaps, restitution 1: 20 impacts")?,
        cradle("cradle-0.8", "the same with restitution 0.8: 44 impacts")?,
        block()?,
    ])
}

/// Drops a ball from 1 m: restitution 0.8, ten impacts.
fn ball() -> Case {
    const T_END: f64 = 3.6;
    let problem = Ball { g: 9.81, e: 0.8, height: 1.0 };
    let ours = Ours { model: Written(problem), input: |_: f64| (), start: problem.start() };
    let mut entries = peers::entries::<2, 1, 3, _>(problem, T_END);
    entries.extend(peers::ours(&ours, T_END));
    let Ball { g, e, height } = problem;
    Case {
        name: "ball",
        summary: "a ball dropped from 1 m, restitution 0.8: ten impacts, in closed form",
        t_end: T_END,
        reference: problem.reference(T_END),
        entries,
        parameters: format!("problem ball\nt_end {T_END:?}\ng {g:?}\ne {e:?}\nheight {height:?}\n"),
    }
}

/// Returns the stroke of model B, a sum of `bells` by height (rad), time (s) and 1/width (1/s).
///
/// Only the position: where b1 is zero nothing else of the input enters, and the peers compute
/// nothing else.
fn stroke(bells: [[f64; 3]; 3]) -> impl Fn(f64) -> Motion + Clone {
    move |t| {
        let position = bells.iter().fold(0.0, |sum, [a, tc, per_w]| {
            let z = (t - tc) * per_w;
            sum + a * (-z * z).exp()
        });
        Motion { position, ..Motion::default() }
    }
}

fn model_b(name: &'static str, file: &str, summary: &'static str) -> Result<Case, String> {
    let ModelBCase { problem, parameters, t_end, reference } = reference::model_b(file)?;
    let ours = shipped(&parameters, stroke(problem.bells))?;
    let mut entries = peers::entries::<4, 2, 5, _>(problem, t_end);
    entries.extend(peers::ours(&ours, t_end));
    Ok(Case { name, summary, t_end, reference, entries, parameters: problem.lines(t_end) })
}

fn cradle(name: &'static str, summary: &'static str) -> Result<Case, String> {
    contact::<Cradle, 10, 4, 11>(name, "cradle", summary, |of| {
        let gaps = [of("gap0")?, of("gap1")?, of("gap2")?, of("gap3")?];
        let (square, e, pulled) = (of("w")?.powi(2), of("e")?, of("pulled")?);
        Some(Cradle { square, e, pulled, gaps })
    })
}

fn block() -> Result<Case, String> {
    let summary = "a block that falls on a floor with friction: it sticks, rocks and slides";
    contact::<Block, 4, 3, 5>("block", "block", summary, |of| {
        #[expect(clippy::cast_possible_truncation, reason = "1, 0 or −1")]
        let sign = |name: &str| of(name).map(|value| value as i8);
        let mode = BlockMode { corner: sign("corner")?, slides: sign("slides")? };
        let start = [of("start0")?, of("start1")?, of("start2")?, of("start3")?];
        let (half, g, mu) = ([of("a")?, of("b")?], of("g")?, of("mu")?);
        Some(Block { half, g, mu, start: (mode, start) })
    })
}

fn contact<P, const N: usize, const G: usize, const M: usize>(
    name: &'static str,
    kind: &str,
    summary: &'static str,
    read: impl FnOnce(&dyn Fn(&str) -> Option<f64>) -> Option<P>,
) -> Result<Case, String>
where
    P: Problem<N, G>,
    Written<P, N, G>: Resets<Mode = P::Mode, State = [f64; N], Input = ()>,
{
    let (parameters, t_end, reference) = reference::contact(name)?;
    let problem = read(&|name| parameters.get(name).copied())
        .ok_or_else(|| format!("{name}: a parameter is missing"))?;
    let mut entries = peers::entries::<N, G, M, P>(problem, t_end);
    let ours = Ours { model: Written(problem), input: |_: f64| (), start: problem.start() };
    entries.extend(peers::ours(&ours, t_end));
    let lines = parameters.iter().map(|(name, value)| format!("{name} {value:?}\n"));
    let parameters = format!("problem {kind}\nt_end {t_end:?}\n") + &lines.collect::<String>();
    Ok(Case { name, summary, t_end, reference, entries, parameters })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::{ModelB, ModelBMode as Mode};
    use instruments::NamedModes as _;
    use pode::{Guarded as _, Model as _};

    fn states() -> impl Iterator<Item = [f64; 4]> {
        let mut seed = 1_u64;
        let mut next = move || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        (0..1000).map(move |_| [next(), next(), 10.0 * next(), 10.0 * next()])
    }

    #[test]
    fn the_peers_equations_are_those_of_the_shipped_model() {
        let ModelBCase { problem, parameters, .. } = reference::model_b("model-b-figure6").unwrap();
        let ours = shipped(&parameters, ()).unwrap();
        let (coupled, model) = (ours.start.0, &ours.model);
        let apart = model.modes().map(|(mode, _)| mode).find(|mode| *mode != coupled).unwrap();
        for x in states() {
            for (mode, ours) in [(Mode::Coupled, coupled), (Mode::Apart, apart)] {
                let t = 3.0 * (x[0] + 0.5);
                let input = Motion { position: problem.input(t), ..Motion::default() };
                check(model.derivative(ours, &x, &input), problem.derivative(mode, t, &x));
                let names = <ModelB as Problem<4, 2>>::names(mode);
                for (guard, name) in names.into_iter().enumerate() {
                    let spec = model.guards(ours).iter().find(|spec| spec.name == name).unwrap();
                    let found = model.guard(ours, spec.id, &x, &input);
                    let (value, rate) = problem.guard(mode, guard, &x);
                    check([found.value, found.rate], [value, rate]);
                }
            }
        }
    }

    #[track_caller]
    fn check<const K: usize>(ours: [f64; K], theirs: [f64; K]) {
        let scale = ours.iter().fold(1.0, |most: f64, it| most.max(it.abs()));
        let off = ours.iter().zip(&theirs).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(off < 1e-13 * scale, "{ours:?} is not {theirs:?}");
    }
}
