//! Triangles to pixels, without a graphics card: the same picture on every machine.

use std::collections::BTreeMap;

use eframe::egui::epaint::{ClippedPrimitive, ImageData, ImageDelta, Mesh, Primitive, Vertex};
use eframe::egui::{Color32, Pos2, Rect, TextureId, TexturesDelta};

#[derive(Clone, Debug)]
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) pixels: Vec<Color32>,
}

#[derive(Default)]
pub(crate) struct Rasteriser {
    textures: BTreeMap<u64, Picture>,
}

impl Rasteriser {
    pub(crate) fn take(&mut self, delta: &TexturesDelta) {
        delta.set.iter().for_each(|(id, parts)| {
            parts.iter().for_each(|part| self.take_part(*id, part));
        });
    }

    fn take_part(&mut self, id: TextureId, part: &ImageDelta) {
        let ImageData::Color(image) = &part.image;
        let [width, height] = image.size;
        let Some([left, top]) = part.pos else {
            let texture = Picture { width, height, pixels: image.pixels.clone() };
            self.textures.insert(number(id), texture);
            return;
        };
        let Some(texture) = self.textures.get_mut(&number(id)) else { return };
        for row in 0..height {
            let to = (top + row) * texture.width + left;
            let from = &image.pixels[row * width..(row + 1) * width];
            texture.pixels[to..to + width].copy_from_slice(from);
        }
    }

    pub(crate) fn draw(
        &self,
        size: [usize; 2],
        ground: Color32,
        all: &[ClippedPrimitive],
    ) -> Picture {
        let [width, height] = size;
        let mut picture = Picture { width, height, pixels: vec![ground; width * height] };
        for ClippedPrimitive { clip_rect, primitive } in all {
            if let Primitive::Mesh(mesh) = primitive {
                self.draw_mesh(&mut picture, *clip_rect, mesh);
            }
        }
        picture
    }

    fn draw_mesh(&self, picture: &mut Picture, clip: Rect, mesh: &Mesh) {
        let Some(texture) = self.textures.get(&number(mesh.texture_id)) else { return };
        for triangle in mesh.indices.chunks_exact(3) {
            let corner = |i: usize| mesh.vertices[triangle[i] as usize];
            draw_triangle(picture, clip, texture, [corner(0), corner(1), corner(2)]);
        }
    }
}

const fn number(id: TextureId) -> u64 {
    match id {
        TextureId::Managed(id) | TextureId::User(id) => id,
    }
}

/// Returns twice the area of a triangle, with the sign of its turn.
fn area(a: Pos2, b: Pos2, c: Pos2) -> f32 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

/// Returns `true` if a pixel in the middle of an edge belongs to the triangle on this side.
fn owns(a: Pos2, b: Pos2) -> bool {
    b.y < a.y || (b.y <= a.y && a.x < b.x)
}

fn draw_triangle(picture: &mut Picture, clip: Rect, texture: &Picture, corners: [Vertex; 3]) {
    let [mut a, mut b, c] = corners;
    if area(a.pos, b.pos, c.pos) < 0.0 {
        std::mem::swap(&mut a, &mut b);
    }
    let whole = area(a.pos, b.pos, c.pos);
    if whole <= 0.0 {
        return;
    }
    let bounds = Rect::from_points(&[a.pos, b.pos, c.pos]).intersect(clip);
    let columns = span(bounds.left(), bounds.right(), picture.width);
    for y in span(bounds.top(), bounds.bottom(), picture.height) {
        for x in columns.clone() {
            let at = Pos2::new(x as f32 + 0.5, y as f32 + 0.5);
            let edges = [(b.pos, c.pos), (c.pos, a.pos), (a.pos, b.pos)];
            let shares = edges.map(|(from, to)| area(from, to, at));
            let is_in = shares
                .iter()
                .zip(edges)
                .all(|(share, (from, to))| 0.0 < *share || (0.0 <= *share && owns(from, to)));
            if is_in {
                let shares = shares.map(|share| share / whole);
                let pixel = &mut picture.pixels[y * picture.width + x];
                *pixel = over(shade(texture, [a, b, c], shares), *pixel);
            }
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited before")]
fn span(low: f32, high: f32, size: usize) -> std::ops::Range<usize> {
    let limit = |x: f32| x.clamp(0.0, size as f32) as usize;
    limit((low - 0.5).ceil())..limit((high - 0.5).ceil())
}

fn shade(texture: &Picture, corners: [Vertex; 3], shares: [f32; 3]) -> [f32; 4] {
    let mut color = [0.0; 4];
    let (mut u, mut v) = (0.0, 0.0);
    for (corner, share) in corners.iter().zip(shares) {
        let channels = corner.color.to_array();
        for (sum, channel) in color.iter_mut().zip(channels) {
            *sum += share * f32::from(channel);
        }
        u += share * corner.uv.x;
        v += share * corner.uv.y;
    }
    let texel = sample(texture, u * texture.width as f32 - 0.5, v * texture.height as f32 - 0.5);
    std::array::from_fn(|i| color[i] * texel[i] / 255.0)
}

fn sample(texture: &Picture, x: f32, y: f32) -> [f32; 4] {
    let (left, top) = (x.floor(), y.floor());
    let (right, down) = (x - left, y - top);
    let at = |x: f32, y: f32| {
        let column = span(x + 0.5, x + 1.5, texture.width - 1).start;
        let row = span(y + 0.5, y + 1.5, texture.height - 1).start;
        texture.pixels[row * texture.width + column].to_array().map(f32::from)
    };
    let corners =
        [at(left, top), at(left + 1.0, top), at(left, top + 1.0), at(left + 1.0, top + 1.0)];
    let shares =
        [(1.0 - right) * (1.0 - down), right * (1.0 - down), (1.0 - right) * down, right * down];
    std::array::from_fn(|i| (0..4).map(|k| corners[k][i] * shares[k]).sum())
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast saturates")]
fn over(above: [f32; 4], below: Color32) -> Color32 {
    let rest = 1.0 - above[3] / 255.0;
    let below = below.to_array();
    let mixed: [f32; 4] = std::array::from_fn(|i| above[i] + rest * f32::from(below[i]));
    let [r, g, b, a] = mixed.map(|channel| channel.round() as u8);
    Color32::from_rgba_premultiplied(r, g, b, a)
}
