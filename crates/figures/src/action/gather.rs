use super::again::{quickest, return_time};
use super::figure::{Figure, MeasuredFigures};
use super::grands::{StrokeTime, speeds};
use super::slope::{self, ForceCurve};
use super::stroke::{Miss, Stroke, durations, play, softest};
use super::{drive::StrokeTouch, subject::PianoSubject};
use crate::parallel::in_parallel;

const MIDDLE: u8 = 39;
/// Speeds of the force curves (m/s): four of weighing, and one of playing.
const SLOPES: [f64; 5] = [0.5e-3, 2e-3, 5e-3, 17e-3, 0.5];
/// Strokes of each touch on the middle key.
const STROKES: u32 = 36;
/// Durations of strokes (s), slow to fast.
const DURATIONS: (f64, f64) = (0.4, 6e-3);
/// Strokes on each of the 88 keys.
const SWEEP: u32 = 9;
/// Durations of strokes on each key (s).
const SWEEP_DURATIONS: (f64, f64) = (0.25, 9e-3);
/// Force of a gram's weight (N).
const GF: f64 = 9.806_65e-3;
/// Travel of touch weights, of a dip of 10.16 mm: before the damper (m).
const WEIGHED: (f64, f64) = (2e-3, 4.5e-3);

/// Number of jobs: curves, strokes of both touches, sweeps, softest, two repetitions, return.
pub const JOBS: usize = SLOPES.len() + 2 * STROKES as usize + 88 + 4;

/// Measurements of an instrument.
#[derive(Clone, Debug)]
pub struct Examination {
    pub name: String,
    pub figures: Vec<Figure>,
    pub dip: f64,
    pub slopes: Vec<ForceCurve>,
    pub strokes: Vec<Stroke>,
    pub sweep: Vec<(u8, Vec<Stroke>)>,
    /// Strokes that the model could not follow.
    pub failed: usize,
}

impl Examination {
    pub fn missed(&self) -> usize {
        self.figures.iter().filter(|it| it.pass == Some(false)).count()
    }

    pub const fn failed(&self) -> usize {
        self.failed
    }
}

enum Job {
    Slope(f64),
    Stroke(StrokeTouch, f64),
    Sweep(u8),
    Softest,
    Repetition(f64),
    Return,
}

enum JobOutcome {
    Slope(Option<ForceCurve>),
    Stroke(Result<Stroke, Miss>),
    Sweep(u8, Vec<Result<Stroke, Miss>>),
    Softest(Option<Stroke>),
    Repetition(f64, f64),
    Return(Option<f64>),
}

/// Measures all of `subject` on all processors; calls `progress` after each of [`JOBS`].
pub fn examine(subject: &PianoSubject<'_>, progress: &(dyn Fn() + Sync)) -> Examination {
    let strokes = |touch| durations(DURATIONS, STROKES).map(move |it| Job::Stroke(touch, it));
    let mut jobs: Vec<Job> = SLOPES.into_iter().map(Job::Slope).collect();
    jobs.extend(StrokeTouch::ALL.into_iter().flat_map(strokes));
    jobs.extend((0..88).map(Job::Sweep));
    jobs.extend([Job::Softest, Job::Repetition(1.0 / 3.0), Job::Repetition(1.0), Job::Return]);
    let done = in_parallel(&jobs, &|job| {
        let done = run(subject, job);
        progress();
        done
    });
    gather(subject, done)
}

fn run(subject: &PianoSubject<'_>, job: &Job) -> JobOutcome {
    match *job {
        Job::Slope(speed) => JobOutcome::Slope(slope::measure(subject, MIDDLE, speed)),
        Job::Stroke(touch, duration) => {
            JobOutcome::Stroke(play(subject, MIDDLE, (touch, duration)))
        }
        Job::Sweep(key) => {
            let strokes = durations(SWEEP_DURATIONS, SWEEP);
            JobOutcome::Sweep(
                key,
                strokes.map(|it| play(subject, key, (StrokeTouch::Pressed, it))).collect(),
            )
        }
        Job::Softest => JobOutcome::Softest(softest(subject, MIDDLE)),
        Job::Repetition(part) => JobOutcome::Repetition(part, quickest(subject, MIDDLE, part)),
        Job::Return => JobOutcome::Return(return_time(subject, MIDDLE)),
    }
}

fn gather(subject: &PianoSubject<'_>, done: Vec<JobOutcome>) -> Examination {
    let mut measured = MeasuredFigures::default();
    let mut examination = Examination {
        name: subject.name.to_owned(),
        figures: Vec::new(),
        dip: subject.dip(MIDDLE),
        slopes: Vec::new(),
        strokes: Vec::new(),
        sweep: Vec::new(),
        failed: 0,
    };
    for it in done {
        match it {
            JobOutcome::Slope(curve) => examination.slopes.extend(curve),
            JobOutcome::Stroke(stroke) => examination.take(stroke),
            JobOutcome::Sweep(key, strokes) => {
                examination.failed += strokes.iter().filter(|it| **it == Err(Miss::Failed)).count();
                examination.sweep.push((key, strokes.into_iter().flatten().collect()));
            }
            JobOutcome::Softest(stroke) => {
                measured.maybe("softest", stroke.and_then(|it| it.thrown));
            }
            JobOutcome::Repetition(part, rate) if part < 1.0 => {
                measured.set("repetition_third", rate);
            }
            JobOutcome::Repetition(_, rate) => measured.set("repetition_full", rate),
            JobOutcome::Return(time) => measured.maybe("return", time.map(|it| 1e3 * it)),
        }
    }
    weigh(examination.dip, &examination.slopes, &mut measured);
    let string = subject.parameter("string_height", MIDDLE);
    let slow = examination.slopes.iter().find_map(|it| it.highest);
    measured.maybe("let_off", string.zip(slow).map(|(string, top)| 1e3 * (string - top)));
    compare(&examination, &mut measured);
    follow(&examination, &mut measured);
    let lift = 100.0 * subject.open(MIDDLE).damper_lift() / examination.dip;
    measured.maybe("damper_lift", Some(lift));
    examination.figures = measured.figures(subject.expected);
    examination
}

impl Examination {
    fn take(&mut self, stroke: Result<Stroke, Miss>) {
        match stroke {
            Ok(stroke) => self.strokes.push(stroke),
            Err(Miss::Failed) => self.failed += 1,
            Err(Miss::Silent) => {}
        }
    }

    /// Returns the strokes on the middle key with a touch, from soft to loud.
    pub fn strokes_of(&self, touch: StrokeTouch) -> Vec<Stroke> {
        let mut strokes: Vec<_> =
            self.strokes.iter().filter(|it| it.touch == touch).copied().collect();
        strokes.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        strokes
    }
}

const WEIGHTS: [[&str; 3]; 4] = [
    ["down_weight_0.5mm_s", "up_weight_0.5mm_s", "hump_0.5mm_s"],
    ["down_weight_2mm_s", "up_weight_2mm_s", "hump_2mm_s"],
    ["down_weight_5mm_s", "up_weight_5mm_s", "hump_5mm_s"],
    ["down_weight_17mm_s", "up_weight_17mm_s", "hump_17mm_s"],
];

pub(super) fn weigh(dip: f64, slopes: &[ForceCurve], measured: &mut MeasuredFigures) {
    let scale = dip / super::drive::USUAL_DIP;
    let range = (WEIGHED.0 * scale, WEIGHED.1 * scale);
    let with_speed =
        |speed: f64| slopes.iter().find(move |it| it.speed.to_bits() == speed.to_bits());
    for (speed, [down, up, hump]) in SLOPES.into_iter().zip(WEIGHTS) {
        let Some(curve) = with_speed(speed) else { continue };
        measured.maybe(down, ForceCurve::mean(&curve.down, range).map(|it| it / GF));
        measured.maybe(up, ForceCurve::mean(&curve.up, range).map(|it| it / GF));
        measured.maybe(hump, curve.hump(dip).map(|it| it.force));
    }
    let middle = with_speed(SLOPES[1]).and_then(|it| it.hump(dip));
    measured.maybe("hump_place", middle.map(|it| 1e3 * it.at));
    measured.maybe("aftertouch", middle.map(|it| 1e3 * (dip - it.at)));
    // No hump at all counts as masked, too.
    let fast = with_speed(SLOPES[4]);
    let rise = |it: &ForceCurve| it.hump(dip).map_or(0.0, |hump| hump.rise);
    measured.maybe("hump_masked", fast.map(rise));
    let works = || slopes.iter().map(|it| it.work);
    measured.maybe("cycle_work", works().reduce(f64::min).map(|it| 1e3 * it));
    let residuals = slopes.iter().map(|it| it.residual.abs() / it.work.abs());
    measured.maybe("energy_residual", residuals.reduce(f64::max));
}

fn compare(examination: &Examination, measured: &mut MeasuredFigures) {
    const NAMES: [[&str; 2]; 3] = [
        ["travel_pressed", "travel_struck"],
        ["key_bottom_pressed", "key_bottom_struck"],
        ["free_flight_pressed", "free_flight_struck"],
    ];
    for (what, names) in StrokeTime::ALL.into_iter().zip(NAMES) {
        for (touch, name) in StrokeTouch::ALL.into_iter().zip(names) {
            let (low, high) = speeds(touch);
            let strokes = examination.strokes_of(touch);
            let within = strokes.iter().filter(|it| (low..=high).contains(&it.speed));
            let excess =
                within.filter_map(|it| Some(what.excess(touch, it.speed, it.timed(what)?)));
            measured.maybe(name, excess.reduce(f64::max));
        }
    }
    let pressed = examination.strokes_of(StrokeTouch::Pressed);
    measured.maybe("key_bottom_zero", zero_of_key_bottom(&pressed));
    let gap = |strokes: &[Stroke], speed| at(strokes, speed, Stroke::gap).map(|it| 1e3 * it);
    measured.maybe("gap_soft", gap(&pressed, 0.5));
    let loud =
        gap(&pressed, 5.0).or_else(|| gap(&examination.strokes_of(StrokeTouch::Struck), 5.0));
    measured.maybe("gap_loud", loud);
    let speeds = examination.strokes.iter().map(|it| it.speed);
    measured.maybe("loudest", speeds.reduce(f64::max));
}

/// Returns the speed above which the key reaches its bottom before the hammer the string (m/s).
fn zero_of_key_bottom(strokes: &[Stroke]) -> Option<f64> {
    strokes.windows(2).find_map(|pair| {
        let (a, b) = (pair[0].key_bottom?, pair[1].key_bottom?);
        let part = a / (a - b);
        (a > 0.0 && b <= 0.0).then(|| pair[0].speed + part * (pair[1].speed - pair[0].speed))
    })
}

/// Interpolates a quantity of strokes, in order of speed, at `speed` (m/s).
fn at(strokes: &[Stroke], speed: f64, of: impl Fn(&Stroke) -> Option<f64>) -> Option<f64> {
    strokes.windows(2).find_map(|pair| {
        let (low, high) = (pair[0].speed, pair[1].speed);
        let (a, b) = (of(&pair[0])?, of(&pair[1])?);
        let is_within = low <= speed && speed <= high && low < high;
        is_within.then(|| a + (speed - low) / (high - low) * (b - a))
    })
}

fn follow(examination: &Examination, measured: &mut MeasuredFigures) {
    /// Speed above which strokes must be caught (m/s).
    const CHECKED_ABOVE: f64 = 1.0;
    let all = || {
        let swept = examination.sweep.iter().flat_map(|(_, strokes)| strokes);
        examination.strokes.iter().chain(swept)
    };
    let caught = || {
        all().filter(|it| it.speed > CHECKED_ABOVE).filter_map(|it| it.checked).map(|it| 1e3 * it)
    };
    measured.maybe("check_lowest", caught().reduce(f64::max));
    measured.maybe("check_highest", caught().reduce(f64::min));
    measured.set("second_strikes", all().filter(|it| it.strikes > 1).count() as f64);
    let travels = || {
        examination.sweep.iter().filter_map(|(_, strokes)| {
            let mut strokes = strokes.clone();
            strokes.sort_by(|a, b| a.speed.total_cmp(&b.speed));
            at(&strokes, 1.0, |it| Some(it.travel))
        })
    };
    let (low, high) = (travels().reduce(f64::min), travels().reduce(f64::max));
    measured.maybe("pitch", low.zip(high).map(|(low, high)| high / low));
}
