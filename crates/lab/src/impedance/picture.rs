//! Draws |Z|, its phase and Re Z over frequency, each band that is not passive shaded.

use figures::plot::color::{CURVES, Color, Stroke};
use figures::plot::picture::{
    CurveLook, Picture, PictureArea, PictureAxis, PictureCurve, PicturePanel,
};

use crate::impedance::curve::{ImpedanceCurve, ImpedancePoint};

/// Maximum ratio of the shown Re Z above zero to that below, if any is below.
const HIGHEST: f64 = 6.0;
const SHADE: f64 = 0.2;

pub(crate) fn picture(title: String, curves: &[ImpedanceCurve]) -> Picture {
    let panel = |y: PictureAxis, value: fn(&ImpedancePoint) -> f64| {
        let curve = |(number, it): (usize, &ImpedanceCurve)| {
            let points = it.points.iter().map(|it| (it.frequency, value(it))).collect();
            let stroke = Stroke::new(CURVES[number % CURVES.len()], 1.9);
            PictureCurve::new(it.name.as_str(), stroke, CurveLook::Line, points)
        };
        PicturePanel {
            x: frequencies(curves),
            y: vec![y],
            areas: curves.iter().enumerate().flat_map(|(number, it)| shades(number, it)).collect(),
            curves: curves.iter().enumerate().map(curve).collect(),
            ..PicturePanel::default()
        }
    };
    let phase = PictureAxis::linear("phase [°]").between((-190.0, 190.0));
    let panels = vec![
        panel(PictureAxis::logarithmic("|Z| [N·s/m]"), ImpedancePoint::magnitude),
        panel(phase, ImpedancePoint::phase),
        panel(PictureAxis::linear("Re Z [N·s/m]").between(real_ends(curves)), |it| it.real),
    ];
    Picture { title, columns: 1, size: (780.0, 180.0), panels, ..Picture::default() }
}

fn frequencies(curves: &[ImpedanceCurve]) -> PictureAxis {
    let all = curves.iter().flat_map(|it| &it.points).map(|it| it.frequency);
    let (low, high) = extent(all);
    let ends = if low < high { (low, high) } else { (1.0, 10.0) };
    PictureAxis::logarithmic("frequency [Hz]").between(ends)
}

/// Returns the ends of the axis of Re Z: a resonance would hide the negative part.
fn real_ends(curves: &[ImpedanceCurve]) -> (f64, f64) {
    let real = curves.iter().flat_map(|it| &it.points).map(|it| it.real);
    let (low, highest) = extent(real.chain([0.0]));
    let high = if low < 0.0 { highest.min(HIGHEST * -low) } else { highest };
    let room = (0.08 * (high - low)).max(1e-9);
    (low - room, high + room)
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    values.fold(ends, |(low, high), it| (low.min(it), high.max(it)))
}

fn shades(number: usize, curve: &ImpedanceCurve) -> impl Iterator<Item = PictureArea> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let thin = |part: u8| (255.0 - SHADE * (255.0 - f64::from(part))).round() as u8;
    let Color(red, green, blue) = CURVES[number % CURVES.len()];
    let color = Color(thin(red), thin(green), thin(blue));
    let name = format!("not passive: {}", curve.name);
    curve.active_bands().into_iter().map(move |band| PictureArea {
        x: (band.from, band.to),
        y: None,
        color,
        name: name.clone(),
        text: String::new(),
    })
}
