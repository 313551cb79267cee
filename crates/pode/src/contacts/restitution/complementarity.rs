//! A linear complementarity problem with a positive semidefinite matrix: find p ≥ 0 so that
//! w = q + G p ≥ 0 and one of each pair is zero.
//!
//! It is the dual of a strictly convex quadratic program, the least change of speeds that meets all
//! bounds, and is solved by its dual active-set method `[GI83]`: violated bounds become active one
//! at a time, and those whose impulse would turn negative are dropped on the way. Bounds that
//! depend on active ones, as in overdetermined contacts, are met by dropping, or cannot be met; so
//! the matrix of the active ones is always regular. The objective rises with every added bound, so
//! no active set recurs and their number bounds the work; usually it takes about as many steps as
//! contacts.

use crate::math::sqrt;

const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Fraction of its terms that a bound that counts as met may miss.
const MET: f64 = 1e-10;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Solution {
    Exact,
    Contradiction,
}

/// Finds p for the matrix `g` and `q`, a sum of terms of these `sizes`.
pub(super) fn solve<const N: usize>(
    g: &[[f64; N]; N],
    q: &[f64; N],
    sizes: &[f64; N],
) -> ([f64; N], Solution) {
    let mut problem = Problem::scaled(g, q, sizes);
    for _ in 0..most_steps(N) {
        let Some(violated) = problem.most_violated() else { break };
        problem.meet(violated);
    }
    let impulses = core::array::from_fn(|i| problem.p[i] * problem.scale[i]);
    (impulses, if problem.is_solved() { Solution::Exact } else { Solution::Contradiction })
}

const fn most_steps(n: usize) -> usize {
    1 << if n < 16 { n } else { 16 }
}

/// State of an inactive bound while no other one becomes active.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Fate {
    Open,
    /// Follows from the active ones, within rounding.
    Met,
    GivenUp,
}

struct Problem<const N: usize> {
    g: [[f64; N]; N],
    q: [f64; N],
    sizes: [f64; N],
    /// Factor of each entry of the scaled p; 0 for a contact that no impulse moves.
    scale: [f64; N],
    p: [f64; N],
    active: [usize; N],
    count: usize,
    fate: [Fate; N],
}

impl<const N: usize> Problem<N> {
    fn scaled(g: &[[f64; N]; N], q: &[f64; N], sizes: &[f64; N]) -> Self {
        let scale: [f64; N] =
            core::array::from_fn(|i| if g[i][i] > 0.0 { 1.0 / sqrt(g[i][i]) } else { 0.0 });
        Self {
            g: core::array::from_fn(|i| core::array::from_fn(|j| scale[i] * g[i][j] * scale[j])),
            q: core::array::from_fn(|i| if scale[i] > 0.0 { scale[i] * q[i] } else { q[i] }),
            sizes: core::array::from_fn(|i| {
                if scale[i] > 0.0 { scale[i] * sizes[i] } else { sizes[i] }
            }),
            scale,
            p: [0.0; N],
            active: [0; N],
            count: 0,
            fate: [Fate::Open; N],
        }
    }

    /// Returns w at `k`, and the size of its terms.
    fn slack(&self, k: usize) -> (f64, f64) {
        let terms = self.g[k].iter().zip(&self.p).map(|(g, p)| g * p);
        terms.fold((self.q[k], self.sizes[k]), |(w, size), term| (w + term, size + term.abs()))
    }

    fn is_active(&self, k: usize) -> bool {
        self.active[..self.count].contains(&k)
    }

    fn most_violated(&self) -> Option<usize> {
        let (mut worst, mut lowest) = (None, 0.0);
        for k in (0..N).filter(|k| !self.is_active(*k) && self.fate[*k] == Fate::Open) {
            let (w, size) = self.slack(k);
            if w < -ROUNDING * size && w < lowest {
                (worst, lowest) = (Some(k), w);
            }
        }
        worst
    }

    fn is_solved(&self) -> bool {
        (0..N).all(|k| {
            let (w, size) = self.slack(k);
            w >= -MET * size && (w <= MET * size || !self.is_active(k))
        })
    }

    /// Raises the impulse of bound `k` until it is met, dropping others on the way.
    fn meet(&mut self, k: usize) {
        for _ in 0..=N {
            let (fallen, curvature) = self.response(k);
            let (w, size) = self.slack(k);
            let noise = ROUNDING * self.condition();
            let is_dependent = curvature <= noise;
            let dropped = self.first_used_up(&fallen, noise);
            if is_dependent && -w <= noise * size {
                self.fate[k] = Fate::Met;
                return self.settle();
            }
            let whole = if is_dependent { f64::INFINITY } else { (-w / curvature).max(0.0) };
            let way = whole.min(dropped.0);
            if way == f64::INFINITY {
                self.fate[k] = Fate::GivenUp;
                self.p[k] = 0.0;
                return self.settle();
            }
            self.p[k] += way;
            for (place, fall) in fallen.iter().enumerate().take(self.count) {
                self.p[self.active[place]] -= way * fall;
            }
            match dropped.1 {
                Some(place) if dropped.0 < whole => self.drop(place),
                _ => {
                    self.active[self.count] = k;
                    self.count += 1;
                    self.fate = [Fate::Open; N];
                    return self.settle();
                }
            }
        }
    }

    /// Returns the fall of the active impulses per impulse at `k`, and the rise of w there.
    fn response(&self, k: usize) -> ([f64; N], f64) {
        let column = core::array::from_fn(|place| self.g[self.active[place]][k]);
        let fallen = self.solved(&column);
        let along: f64 = (0..self.count).map(|place| column[place] * fallen[place]).sum();
        (fallen, self.g[k][k] - along)
    }

    /// Returns the step at which the first active impulse, falling so, is used up, and its index.
    fn first_used_up(&self, fallen: &[f64; N], noise: f64) -> (f64, Option<usize>) {
        let falling = (0..self.count).filter(|place| fallen[*place] > noise);
        let reaches =
            falling.map(|place| (self.p[self.active[place]] / fallen[place], Some(place)));
        reaches.fold((f64::INFINITY, None), |first, it| if it.0 < first.0 { it } else { first })
    }

    fn drop(&mut self, place: usize) {
        self.p[self.active[place]] = 0.0;
        self.count -= 1;
        self.active.copy_within(place + 1..=self.count, place);
    }

    /// Recomputes the active impulses, so that rounding does not add up.
    fn settle(&mut self) {
        let aims = core::array::from_fn(|place| -self.q[self.active[place]]);
        let solved = self.solved(&aims);
        for (place, p) in solved.iter().enumerate().take(self.count) {
            self.p[self.active[place]] = p.max(0.0);
        }
    }

    /// Returns the amplification of rounding by the active bounds' matrix: its inverse least pivot.
    fn condition(&self) -> f64 {
        let l = self.factor();
        let least = (0..self.count).map(|i| l[i][i]).fold(1.0, f64::min);
        1.0 / (least * least)
    }

    fn factor(&self) -> [[f64; N]; N] {
        let mut l = [[0.0; N]; N];
        for i in 0..self.count {
            for j in 0..i {
                l[i][j] = self.left(&l, i, j) / l[j][j];
            }
            l[i][i] = sqrt(self.left(&l, i, i));
        }
        l
    }

    fn left(&self, l: &[[f64; N]; N], i: usize, j: usize) -> f64 {
        let done: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
        self.g[self.active[i]][self.active[j]] - done
    }

    fn solved(&self, b: &[f64; N]) -> [f64; N] {
        let (l, mut x) = (self.factor(), *b);
        for i in 0..self.count {
            let done: f64 = (0..i).map(|k| l[i][k] * x[k]).sum();
            x[i] = (x[i] - done) / l[i][i];
        }
        for i in (0..self.count).rev() {
            let done: f64 = (i + 1..self.count).map(|k| l[k][i] * x[k]).sum();
            x[i] = (x[i] - done) / l[i][i];
        }
        x
    }
}
