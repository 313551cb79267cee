//! Draws a map: a colour for each verdict, the measured boundary, and the lines of theory.

use super::map::{StabilityMap, StabilityStudy};
use super::{axis::MapAxis, judge::LoopVerdict};
use figures::plot::color::{Color, INK, Stroke};
use figures::plot::picture::{
    CurveLook, Picture, PictureArea, PictureAxis, PictureCurve, PicturePanel,
};
use figures::plot::{axis::AxisScale, marker::MarkerShape::Circle};

/// Colours of theories, different from those of verdicts.
const LINES: [Color; 4] =
    [Color(0, 60, 140), Color(140, 30, 120), Color(90, 90, 90), Color(20, 20, 20)];

const fn color(verdict: LoopVerdict) -> Color {
    match verdict {
        LoopVerdict::Rests => Color(178, 221, 204),
        LoopVerdict::Rings => Color(250, 224, 158),
        LoopVerdict::MakesEnergy => Color(240, 176, 148),
        LoopVerdict::Fails => Color(206, 206, 206),
    }
}

/// Draws a map of a study, with lines on all that is no axis.
pub(super) fn picture(
    study: &StabilityStudy<'_>,
    map: &StabilityMap,
    settings: Vec<String>,
) -> Picture {
    let [across, up] = &study.axes;
    let x = |part: f64| shown(across, part);
    let y = |part: f64| shown(up, part);
    let places = |places: &[(f64, f64)]| places.iter().map(|it| (x(it.0), y(it.1))).collect();
    let boundary = map.crossings.iter().enumerate().flat_map(|(column, crossings)| {
        crossings.iter().map(move |it| (study.middle(0, column), up.part(*it)))
    });
    let boundary: Vec<_> = boundary.collect();
    let marks = CurveLook::Marks(Circle);
    let name = "boundary, by bisection";
    let mut curves = vec![PictureCurve::new(name, Stroke::new(INK, 0.5), marks, places(&boundary))];
    for (line, color) in map.theories.iter().zip(LINES).filter(|it| !it.0.lines.is_empty()) {
        let stroke = Stroke { is_dashed: true, ..Stroke::new(color, 1.8) };
        let curve = PictureCurve::new(line.theory.title, stroke, CurveLook::Line, Vec::new());
        let stretches = line.lines.iter().map(|it| places(it)).collect();
        curves.push(PictureCurve { stretches, ..curve });
    }
    let panel = PicturePanel {
        x: picture_axis(across),
        y: vec![picture_axis(up)],
        areas: areas(map, [&x, &y]),
        curves,
        ..PicturePanel::default()
    };
    let title = format!("{}, velocity by {}", study.name, map.estimator.name());
    Picture { notes: settings, size: (516.0, 386.0), ..Picture::of_panel(title, panel) }
}

fn axis_title(axis: &MapAxis) -> String {
    match axis.shown.0.as_str() {
        "" | "1" => axis.title.clone(),
        unit => format!("{} [{unit}]", axis.title),
    }
}

fn shown(axis: &MapAxis, part: f64) -> f64 {
    axis.names()
        .map_or_else(|| axis.value(part) * axis.shown.1, |names| part * names.len() as f64 - 0.5)
}

fn picture_axis(axis: &MapAxis) -> PictureAxis {
    let scale = if axis.is_logarithmic() { AxisScale::Logarithmic } else { AxisScale::Linear };
    let names = axis.names().into_iter().flatten().map(|it| (*it).to_owned()).collect();
    let ends = Some((shown(axis, 0.0), shown(axis, 1.0)));
    PictureAxis { title: axis_title(axis), scale, ends, names }
}

/// Returns each run of cells of one verdict in a column, and the count of all cells with it.
fn areas(map: &StabilityMap, [x, y]: [&dyn Fn(f64) -> f64; 2]) -> Vec<PictureArea> {
    let counts = map.counts();
    let name = |verdict: LoopVerdict| {
        let count = match verdict {
            LoopVerdict::Rests => counts.rests,
            LoopVerdict::Rings => counts.rings,
            LoopVerdict::MakesEnergy => counts.makes_energy,
            LoopVerdict::Fails => counts.fails,
        };
        format!("{} ({count} cells)", verdict.title())
    };
    let across = map.columns.len() as f64;
    let mut areas = Vec::new();
    for (column, cells) in map.columns.iter().enumerate() {
        let up = cells.len() as f64;
        let ends = (x(column as f64 / across), x((column as f64 + 1.0) / across));
        let mut from = 0;
        for run in cells.chunk_by(|a, b| a == b) {
            let to = from + run.len();
            areas.push(PictureArea {
                x: ends,
                y: Some((y(from as f64 / up), y(to as f64 / up))),
                color: color(run[0]),
                name: name(run[0]),
                text: String::new(),
            });
            from = to;
        }
    }
    areas
}
