//! Comparison of pictures with those in `tests/snapshots`.
//!
//! `UPDATE_SNAPSHOTS=1` renews them; a difference is shown in a `.diff.png`.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::{collections::BTreeMap, io::BufWriter};

use dashboard::App;
use eframe::egui::{self, Color32};

use super::TestClock;
use super::raster::{Picture, Rasteriser};

/// Accepted difference of a pixel's channel: a rounding of the last bit on the way.
const CLOSE: u8 = 12;

/// Accepted number of other pixels in a million.
const FEW: usize = 200;

pub(crate) struct Canvas {
    ctx: egui::Context,
    app: App,
    raster: Rasteriser,
    size: [usize; 2],
    frame: u32,
}

impl Canvas {
    pub(crate) fn new(
        size: [usize; 2],
        theme: egui::Theme,
        make: impl FnOnce(&egui::Context) -> App,
    ) -> Self {
        let ctx = egui::Context::default();
        ctx.set_theme(theme);
        let app = make(&ctx);
        ctx.all_styles_mut(|style| style.animation_time = 0.0);
        Self { ctx, app, raster: Rasteriser::default(), size, frame: 0 }
    }

    pub(crate) fn app(&mut self) -> &mut App {
        &mut self.app
    }

    pub(crate) fn play(&mut self, time: &TestClock, seconds: f64) {
        let mut at = 0.0;
        while at < seconds {
            at = f64::min(at + 0.1, seconds);
            time.set(at);
            self.step(Vec::new());
        }
        for _ in 0..3 {
            self.step(Vec::new());
        }
    }

    pub(crate) fn step(&mut self, events: Vec<egui::Event>) -> Vec<egui::epaint::ClippedPrimitive> {
        let [width, height] = self.size;
        self.frame += 1;
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(
                egui::Pos2::ZERO,
                egui::vec2(width as f32, height as f32),
            )),
            time: Some(f64::from(self.frame) / 10.0),
            events,
            ..egui::RawInput::default()
        };
        let app = &mut self.app;
        let mut output = self.ctx.run_ui(input, |ui| app.draw(ui));
        self.raster.take(&output.textures_delta);
        output.textures_delta.clear();
        self.ctx.tessellate(output.shapes, 1.0)
    }

    pub(crate) fn drag(&mut self, from: [f32; 2], to: [f32; 2]) {
        let button = |pos: [f32; 2], pressed| egui::Event::PointerButton {
            pos: pos.into(),
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: egui::Modifiers::NONE,
        };
        self.step(vec![egui::Event::PointerMoved(from.into())]);
        self.step(vec![button(from, true)]);
        self.step(vec![egui::Event::PointerMoved(to.into())]);
        self.step(vec![button(to, false)]);
        self.step(vec![egui::Event::PointerGone]);
        self.step(Vec::new());
    }

    pub(crate) fn picture(&mut self) -> Picture {
        let primitives = self.step(Vec::new());
        self.raster.draw(self.size, Color32::BLACK, &primitives)
    }

    #[track_caller]
    pub(crate) fn check(&mut self, name: &str) {
        let picture = self.picture();
        let path = folder().join(format!("{name}.png"));
        if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
            write(&path, &picture);
            return;
        }
        let Some(expected) = read(&path) else {
            panic!("{} is not there: UPDATE_SNAPSHOTS=1 makes it", path.display());
        };
        let other = differences(&picture, &expected);
        let most = FEW * picture.pixels.len() / 1_000_000;
        if most < other.len() {
            write(&path.with_extension("diff.png"), &marked(&picture, &other));
            write(&path.with_extension("new.png"), &picture);
            panic!("{name}: {} pixels differ, at most {most} may", other.len());
        }
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots")
}

fn differences(picture: &Picture, expected: &Picture) -> Vec<usize> {
    if (picture.width, picture.height) != (expected.width, expected.height) {
        return (0..picture.pixels.len()).collect();
    }
    let differ = |i: &usize| {
        let pair = (picture.pixels[*i].to_array(), expected.pixels[*i].to_array());
        pair.0.iter().zip(pair.1).any(|(a, b)| CLOSE < a.abs_diff(b))
    };
    (0..picture.pixels.len()).filter(differ).collect()
}

fn marked(picture: &Picture, other: &[usize]) -> Picture {
    let mut marked = picture.clone();
    for pixel in &mut marked.pixels {
        let grey = pixel.r() / 4 + pixel.g() / 4 + pixel.b() / 4;
        *pixel = Color32::from_gray(grey);
    }
    for i in other {
        marked.pixels[*i] = Color32::RED;
    }
    marked
}

/// Step of each channel in a file: half the bits, far fewer bytes, no visible difference.
const STEP: u8 = 6;

fn coarse(color: Color32) -> [u8; 3] {
    let round = |channel: u8| (channel / STEP) * STEP + STEP / 2;
    [round(color.r()), round(color.g()), round(color.b())]
}

fn write(path: &Path, picture: &Picture) {
    let colors: Vec<[u8; 3]> = picture.pixels.iter().map(|pixel| coarse(*pixel)).collect();
    let mut count: BTreeMap<[u8; 3], usize> = BTreeMap::new();
    for color in &colors {
        *count.entry(*color).or_default() += 1;
    }
    let file = BufWriter::new(File::create(path).expect("a file in tests/snapshots"));
    let size = [picture.width, picture.height].map(|side| u32::try_from(side).expect("small"));
    let mut encoder = png::Encoder::new(file, size[0], size[1]);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let palette: Vec<[u8; 3]> = count.keys().copied().collect();
    let data = if palette.len() <= 256 {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette.concat());
        encoder.set_filter(png::Filter::NoFilter);
        let index = |color| palette.binary_search(color).expect("in the palette");
        colors.iter().map(|color| u8::try_from(index(color)).expect("256")).collect()
    } else {
        encoder.set_color(png::ColorType::Rgb);
        colors.concat()
    };
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&data).expect("pixels");
}

fn read(path: &Path) -> Option<Picture> {
    let bytes = fs::read(path).ok()?;
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().ok()?;
    let mut data = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut data).ok()?;
    let pixel = |rgb: &[u8]| Color32::from_rgb(rgb[0], rgb[1], rgb[2]);
    Some(Picture {
        width: info.width as usize,
        height: info.height as usize,
        pixels: data.chunks_exact(3).map(pixel).collect(),
    })
}
