//! `letoff lab performance`: music as people play it, on the virtual pianist.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use engine::voice::VoiceBuilder;
use figures::plot::color::{CURVES, Stroke};
use figures::plot::marker::MarkerShape;
use figures::plot::picture::{CurveLook, Picture, PictureAxis, PictureCurve, PicturePanel};
use figures::rehearsal::{PlayedScore, perform};
use haptics::Gesture;
use midi::{Pedal, PedalMove, Velocity};
use pianist::{Pianist, Score, ScoreNote, Spread, Technique};
use scene::{Library, Scene};
use serde::Serialize;

use super::{Failure, prepare_report, print_json, print_page};
use crate::random::SeededRandom;
use crate::report::{PAGE, Report, Table, TableCell};

/// What `letoff lab performance` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab performance --out report
  letoff lab performance springs --notes 100 --seed 7 --json

Notes from a seed, with the statistics of human performances: one key again after 90 to 200 ms,
legato and overlaps, chords whose notes spread over 30 ms with pedals, soft notes of velocity 5 to
40, accents to 110. Each kind is rehearsed and then played in virtual time, and compared with what
was asked for: strikes, onsets, velocities, note ends, release velocities, notes that end early for
the next one, and the rehearsal's evaluations of the model over those of the playing.

Exit codes: 0 done; 1 a file could not be written; 2 wrong usage or scene.")]
pub struct PerformanceArgs {
    /// A scene's name or file.
    #[arg(value_name = "SCENE", default_value = "default")]
    pub scene: String,
    /// Notes of each kind.
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub notes: u32,
    /// Seed of all notes.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Folder for the report: index.html, performance.csv, and the picture as SVG.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Prints the figures as JSON.
    #[arg(long)]
    pub json: bool,
}

/// A kind of music, with its next note: time since the one before (s), key, length (s), velocity.
struct Kind {
    name: &'static str,
    next: fn(&mut SeededRandom, u32) -> (f64, u8, f64, f64),
}

const KINDS: [Kind; 5] = [
    Kind {
        name: "repetitions",
        next: |random, _| {
            let after = random.between(0.09, 0.2);
            (after, 48, 0.75 * after, random.between(13.0, 75.0))
        },
    },
    Kind {
        name: "legato",
        next: |random, n| {
            // Every fourth note is the one before again.
            let key = [39, 41, 43, 43][n as usize % 4];
            let after = random.spread(0.2, 1.0);
            (after, key, random.between(0.3, 1.0), random.between(35.0, 80.0))
        },
    },
    Kind {
        name: "chords",
        next: |random, n| {
            let begins = n.is_multiple_of(3);
            let after = if begins { random.between(0.4, 1.2) } else { random.between(0.0, 0.015) };
            let key = [27, 31, 34][n as usize % 3];
            (after, key, random.between(0.25, 0.9), random.between(40.0, 90.0))
        },
    },
    Kind {
        name: "soft notes",
        next: |random, n| {
            let key = [51, 55, 58, 60][n as usize % 4];
            (random.spread(0.15, 0.6), key, random.between(0.1, 0.5), random.between(5.0, 40.0))
        },
    },
    Kind {
        name: "accents",
        next: |random, n| {
            let key = [36, 40][n as usize % 2];
            let velocity = if n.is_multiple_of(5) { random.between(95.0, 110.0) } else { 50.0 };
            (random.between(0.12, 0.4), key, random.between(0.08, 0.3), velocity)
        },
    },
];

fn score(kind: &Kind, n_notes: u32, random: &mut SeededRandom) -> Score {
    let mut score = Score::default();
    let mut now = 0.0;
    for n in 0..n_notes {
        let (after, key, length, velocity) = (kind.next)(random, n);
        now += after;
        if let Some(before) = score.notes.iter_mut().rfind(|it: &&mut ScoreNote| it.key == key) {
            before.end = before.end.min(now);
        }
        let release = (n % 2 == 0).then(|| Velocity::nearest(random.between(20.0, 64.0)));
        let velocity = Velocity::nearest(velocity).get();
        score.notes.push(ScoreNote { key, onset: now, end: now + length, velocity, release });
        if kind.name == "chords" && n.is_multiple_of(3) {
            for (at, depth) in [(now - 0.05, 0.0), (now + 0.1, random.between(0.4, 1.0))] {
                score.pedals.push(PedalMove { pedal: Pedal::Sustain, at, depth });
            }
        }
    }
    score
}

#[derive(Debug, Serialize)]
struct KindRow {
    kind: &'static str,
    notes: usize,
    struck: usize,
    missed: usize,
    extra: usize,
    onset_ms: [f64; 2],
    velocity: [f64; 2],
    end_ms: [f64; 2],
    release_velocity: [f64; 2],
    /// Notes that end early for the next one.
    cuts: usize,
    work: f64,
}

impl KindRow {
    fn new(kind: &'static str, it: &PlayedScore) -> Self {
        let errors = |spread: Spread| [spread.p50, spread.p99];
        let found = &it.assessment;
        let [rehearsed, played] = it.evaluations;
        Self {
            kind,
            notes: found.played,
            struck: found.played - found.missed,
            missed: found.missed,
            extra: found.extra,
            onset_ms: errors(found.onset_error_ms),
            velocity: errors(found.velocity_error),
            end_ms: errors(found.end_error_ms),
            release_velocity: errors(found.release_error.unwrap_or_default()),
            cuts: it.performance.cuts.len(),
            work: rehearsed as f64 / played.max(1) as f64,
        }
    }

    fn cells(&self) -> Vec<TableCell> {
        let counts = [self.notes, self.struck, self.missed, self.extra].map(|it| it as f64);
        let errors = [self.onset_ms, self.velocity, self.end_ms, self.release_velocity].concat();
        let numbers = counts.into_iter().chain(errors).chain([self.cuts as f64, self.work]);
        let numbers = numbers.map(TableCell::Number);
        [TableCell::words(self.kind)].into_iter().chain(numbers).collect()
    }
}

pub(super) fn run(args: &PerformanceArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let failed = |error: &dyn std::fmt::Display| Failure::Running(error.to_string());
    let scene = Scene::load(&Library::default(), &args.scene, &[])
        .map_err(|mistakes| Failure::Usage(mechanism::rendered(&mistakes)))?;
    prepare_report(args.out.as_deref())?;
    let builder = VoiceBuilder::new(&scene).map_err(|error| failed(&error))?;
    let technique = Technique { hold: Gesture::hold_of(scene.rig.dip), ..Technique::default() };
    let pianist = Pianist { curve: scene.midi.curve, technique, ..Pianist::default() };
    let mut rows = Vec::new();
    for (system, kind) in (0..).zip(&KINDS) {
        let mut score = score(kind, args.notes, &mut SeededRandom::new(args.seed, system));
        score.notes.retain(|note| scene.keys[usize::from(note.key)].is_some());
        let played = perform(&builder, &pianist, &score).map_err(|error| failed(&error))?;
        rows.push(KindRow::new(kind.name, &played));
    }
    let table = table(&rows);
    if let Some(folder) = &args.out {
        let title =
            format!("{}: {} notes of each kind, seed {}", scene.name, args.notes, args.seed);
        let mut report = Report::new(format!("What the virtual pianist meets on {}", scene.name));
        report.text(&title);
        report.table(&table);
        report.csv("performance", &table);
        report.picture("performance", &picture(&rows));
        report.write(folder).map_err(|error| failed(&error))?;
    }
    if args.json {
        return print_json(&rows, out);
    }
    for row in &rows {
        let KindRow { kind, struck, notes, onset_ms, velocity, end_ms, release_velocity, .. } = row;
        writeln!(
            out,
            "{kind:12} {struck} of {notes} struck; p99: onset {:.2} ms, velocity {:.0}, end {:.1} ms, \
             release velocity {:.0}; {} cut, rehearsal {:.1} times the work",
            onset_ms[1], velocity[1], end_ms[1], release_velocity[1], row.cuts, row.work
        )?;
    }
    print_page(args.out.as_deref(), PAGE, out)
}

fn table(rows: &[KindRow]) -> Table {
    let columns = [
        ("kind", "Kind"),
        ("notes", "Notes"),
        ("struck", "Struck"),
        ("missed", "Missed"),
        ("extra", "Extra"),
        ("onset_p50_ms", "Onset p50 (ms)"),
        ("onset_p99_ms", "p99"),
        ("velocity_p50", "Velocity p50"),
        ("velocity_p99", "p99"),
        ("end_p50_ms", "End p50 (ms)"),
        ("end_p99_ms", "p99"),
        ("release_p50", "Release velocity p50"),
        ("release_p99", "p99"),
        ("cuts", "Cuts"),
        ("work", "Rehearsal over run"),
    ];
    Table::new(columns).with(rows.iter().map(KindRow::cells))
}

fn picture(rows: &[KindRow]) -> Picture {
    let curve = |name, color, value: fn(&KindRow) -> f64| {
        let points = rows.iter().enumerate().map(|(n, row)| (n as f64, value(row).max(0.01)));
        let stroke = Stroke::new(CURVES[color], 1.5);
        PictureCurve::new(name, stroke, CurveLook::Marks(MarkerShape::Circle), points.collect())
    };
    let names = rows.iter().map(|row| row.kind.to_owned()).collect();
    let x = PictureAxis { names, ..PictureAxis::linear("").between((-0.5, 4.5)) };
    let panel = PicturePanel {
        x,
        y: vec![PictureAxis::logarithmic("error of 99 % of the notes (ms)")],
        curves: vec![
            curve("onset", 0, |row| row.onset_ms[1]),
            curve("note end", 1, |row| row.end_ms[1]),
        ],
        ..PicturePanel::default()
    };
    Picture::of_panel("Onsets and note ends", panel)
}
