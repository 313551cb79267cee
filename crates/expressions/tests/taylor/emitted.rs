//! Written by `UPDATE=1 cargo test -p expressions --test all taylor`; not by hand.

#![expect(clippy::pedantic, unused_variables, reason = "generated")]

use equations::functions;
use pode::series::lanes::{SeriesLanes, SeriesPair};
use pode::series::rows::PER_ORDER;

use super::{Expansion, INPUT_TERMS, Motion, math};

/// Six functions of x.
#[rustfmt::skip]
pub(super) fn functions0(
    _c: &[f64; 1],
    _s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 1]>,
) {
    let x = out.terms[0];
    let v0 = x[0];
    let v1 = v0 * v0;
    let (v2, v3) = math::sin_cos(v0);
    let v5 = 0.3_f64;
    let v6 = v5 * v2;
    let v7 = 1.2000000000000002_f64;
    let v8 = v7 + v1;
    let v9 = v8 + v6;
    let v10 = 1.0_f64;
    let (v11, v12) = math::sin_cos(v9);
    let v14 = math::tanh(v9);
    let v15 = v14 * v14;
    let v16 = v10 - v15;
    let v17 = math::exp(v9);
    let v18 = v10 / v9;
    let v19 = math::ln(v9);
    let v20 = math::sqrt(v9);
    let per18 = 1.0 / v9;
    let per20 = 0.5 / v20;
    let mut lanes0 = SeriesLanes::<6>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v10];
    out.guards[0][0] = v11;
    out.guards[1][0] = v12;
    out.guards[2][0] = v14;
    out.guards[3][0] = v17;
    out.guards[4][0] = v19;
    out.guards[5][0] = v20;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w1 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w2 = e0[0].both()[1] * per_k + w0 * v3;
        let w3 = -(e0[1].both()[0] * per_k + w0 * v2);
        let w6 = v5 * w2;
        let w8 = w1;
        let w9 = w8 + w6;
        let w11 = e0[1].both()[1] * per_k + w9 * v12;
        let w12 = -(e0[2].both()[0] * per_k + w9 * v11);
        let w14 = e0[2].both()[1] * per_k + w9 * v16;
        let w15 = e0[3].both()[0] + 2.0 * v14 * w14;
        let w16 = -w15;
        let w17 = e0[3].both()[1] * per_k + w9 * v17;
        let w18 = (0.0 - e0[4].both()[0] - v18 * w9) * per18;
        let w19 = e0[4].both()[1] * per_k + w9 * v18;
        let w20 = (w9 - e0[5].both()[0]) * per20;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w11;
        out.guards[1][k] = w12;
        out.guards[2][k] = w14;
        out.guards[3][k] = w17;
        out.guards[4][k] = w19;
        out.guards[5][k] = w20;
        lanes0.enter(k, [SeriesPair::new(w0, k as f64 * w0), SeriesPair::new(k as f64 * w0, k as f64 * w9), SeriesPair::new(k as f64 * w9, k as f64 * w9), SeriesPair::new(w14, k as f64 * w9), SeriesPair::new(w9, k as f64 * w9), SeriesPair::new(w20, 0.0)], [SeriesPair::new(w0, w3), SeriesPair::new(w2, w12), SeriesPair::new(w11, w16), SeriesPair::new(w14, w17), SeriesPair::new(w18, w18), SeriesPair::new(w20, 0.0)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w1 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w2 = e0[0].both()[1] * per_k + w0 * v3;
    let w6 = v5 * w2;
    let w8 = w1;
    let w9 = w8 + w6;
    let w11 = e0[1].both()[1] * per_k + w9 * v12;
    let w12 = -(e0[2].both()[0] * per_k + w9 * v11);
    let w14 = e0[2].both()[1] * per_k + w9 * v16;
    let w17 = e0[3].both()[1] * per_k + w9 * v17;
    let w19 = e0[4].both()[1] * per_k + w9 * v18;
    let w20 = (w9 - e0[5].both()[0]) * per20;
    out.guards[0][k] = w11;
    out.guards[1][k] = w12;
    out.guards[2][k] = w14;
    out.guards[3][k] = w17;
    out.guards[4][k] = w19;
    out.guards[5][k] = w20;
}

/// Six functions of x.
#[rustfmt::skip]
pub(super) fn functions1(
    _c: &[f64; 1],
    _s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 1]>,
) {
    let x = out.terms[0];
    let v0 = x[0];
    let v1 = 1.0_f64;
    let v2 = v0 * v0;
    let (v3, v4) = math::sin_cos(v0);
    let v6 = 0.3_f64;
    let v7 = v6 * v3;
    let v8 = 1.2000000000000002_f64;
    let v9 = v8 + v2;
    let v10 = v9 + v7;
    let v11 = v10.abs();
    let v12 = functions::sign(v10);
    let v13 = functions::logistic(v10);
    let v14 = v13 * v13;
    let v15 = v13 - v14;
    let v16 = functions::softplus(v10);
    let v17 = functions::softplus_area(v10);
    let v18 = v16 * v16;
    let v19 = functions::softplus_square_area(v10);
    let sign11 = functions::sign(v10);
    let mut lanes0 = SeriesLanes::<5>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v1];
    out.guards[0][0] = v11;
    out.guards[1][0] = v12;
    out.guards[2][0] = v16;
    out.guards[3][0] = v13;
    out.guards[4][0] = v17;
    out.guards[5][0] = v19;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w2 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w3 = e0[0].both()[1] * per_k + w0 * v4;
        let w4 = -(e0[1].both()[0] * per_k + w0 * v3);
        let w7 = v6 * w3;
        let w9 = w2;
        let w10 = w9 + w7;
        let w11 = sign11 * w10;
        let w13 = e0[1].both()[1] * per_k + w10 * v15;
        let w14 = e0[2].both()[0] + 2.0 * v13 * w13;
        let w15 = w13 - w14;
        let w16 = e0[2].both()[1] * per_k + w10 * v13;
        let w17 = e0[3].both()[0] * per_k + w10 * v16;
        let w18 = e0[3].both()[1] + 2.0 * v16 * w16;
        let w19 = e0[4].both()[0] * per_k + w10 * v18;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w11;
        out.guards[1][k] = 0.0;
        out.guards[2][k] = w16;
        out.guards[3][k] = w13;
        out.guards[4][k] = w17;
        out.guards[5][k] = w19;
        lanes0.enter(k, [SeriesPair::new(w0, k as f64 * w0), SeriesPair::new(k as f64 * w0, k as f64 * w10), SeriesPair::new(w13, k as f64 * w10), SeriesPair::new(k as f64 * w10, w16), SeriesPair::new(k as f64 * w10, 0.0)], [SeriesPair::new(w0, w4), SeriesPair::new(w3, w15), SeriesPair::new(w13, w13), SeriesPair::new(w16, w16), SeriesPair::new(w18, 0.0)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w2 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w3 = e0[0].both()[1] * per_k + w0 * v4;
    let w7 = v6 * w3;
    let w9 = w2;
    let w10 = w9 + w7;
    let w11 = sign11 * w10;
    let w13 = e0[1].both()[1] * per_k + w10 * v15;
    let w16 = e0[2].both()[1] * per_k + w10 * v13;
    let w17 = e0[3].both()[0] * per_k + w10 * v16;
    let w19 = e0[4].both()[0] * per_k + w10 * v18;
    out.guards[0][k] = w11;
    out.guards[1][k] = 0.0;
    out.guards[2][k] = w16;
    out.guards[3][k] = w13;
    out.guards[4][k] = w17;
    out.guards[5][k] = w19;
}

/// Six functions of x.
#[rustfmt::skip]
pub(super) fn functions2(
    c: &[f64; 1],
    _s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 1]>,
) {
    let x = out.terms[0];
    let v0 = x[0];
    let v1 = 1.0_f64;
    let v2 = 0.5_f64;
    let v3 = v2 * v0;
    let v4 = v3 * v3;
    let v5 = v1 - v4;
    let v6 = math::sqrt(v5);
    let v7 = v1 / v6;
    let v8 = v3.asin();
    let v9 = -1.0_f64;
    let v10 = v9 / v6;
    let v11 = v3.acos();
    let v12 = c[0];
    let v13 = v0 * v0;
    let (v14, v15) = math::sin_cos(v0);
    let v17 = 0.3_f64;
    let v18 = v17 * v14;
    let v19 = 1.2000000000000002_f64;
    let v20 = v19 + v13;
    let v21 = v20 + v18;
    let v22 = v1 / v21;
    let v23 = v12 * v22;
    let v24 = v14 * v22;
    let v25 = v14 * v14;
    let v26 = v21 * v21;
    let v27 = v26 * v21;
    let v28 = v0 * v25;
    let v29 = v28 * v27;
    let v30 = 2.5_f64;
    let v31 = math::powf(v21, v30);
    let per6 = 0.5 / v6;
    let per7 = 1.0 / v6;
    let per10 = 1.0 / v6;
    let per22 = 1.0 / v21;
    let per31 = 1.0 / v21;
    let mut lanes0 = SeriesLanes::<5>::ZERO;
    let mut lanes1 = SeriesLanes::<5>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v1];
    out.guards[0][0] = v8;
    out.guards[1][0] = v11;
    out.guards[2][0] = v23;
    out.guards[3][0] = v24;
    out.guards[4][0] = v29;
    out.guards[5][0] = v31;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let e1 = lanes1.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w3 = v2 * w0;
        let w4 = e0[0].both()[0] + 2.0 * v3 * w3;
        let w5 = -w4;
        let w6 = (w5 - e0[0].both()[1]) * per6;
        let w7 = (0.0 - e0[1].both()[0] - v7 * w6) * per7;
        let w8 = e0[1].both()[1] * per_k + w3 * v7;
        let w10 = (0.0 - e0[2].both()[0] - v10 * w6) * per10;
        let w11 = e0[2].both()[1] * per_k + w3 * v10;
        let w13 = e0[3].both()[0] + 2.0 * v0 * w0;
        let w14 = e0[3].both()[1] * per_k + w0 * v15;
        let w15 = -(e0[4].both()[0] * per_k + w0 * v14);
        let w18 = v17 * w14;
        let w20 = w13;
        let w21 = w20 + w18;
        let w22 = (0.0 - e1[0].both()[0] - v22 * w21) * per22;
        let w23 = v12 * w22;
        let w24 = e1[0].both()[1] + v14 * w22 + w14 * v22;
        let w25 = e1[1].both()[0] + 2.0 * v14 * w14;
        let w26 = e1[1].both()[1] + 2.0 * v21 * w21;
        let w27 = e1[2].both()[0] + v26 * w21 + w26 * v21;
        let w28 = e1[2].both()[1] + v0 * w25 + w0 * v25;
        let w29 = e1[3].both()[0] + v28 * w27 + w28 * v27;
        let w31 = ((v30 + 1.0) * e1[4].both()[0] * per_k - e1[3].both()[1] + v30 * v31 * w21) * per31;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w8;
        out.guards[1][k] = w11;
        out.guards[2][k] = w23;
        out.guards[3][k] = w24;
        out.guards[4][k] = w29;
        out.guards[5][k] = w31;
        lanes0.enter(k, [SeriesPair::new(w3, w6), SeriesPair::new(w6, k as f64 * w3), SeriesPair::new(w6, k as f64 * w3), SeriesPair::new(w0, k as f64 * w0), SeriesPair::new(k as f64 * w0, 0.0)], [SeriesPair::new(w3, w6), SeriesPair::new(w7, w7), SeriesPair::new(w10, w10), SeriesPair::new(w0, w15), SeriesPair::new(w14, 0.0)]);
        lanes1.enter(k, [SeriesPair::new(w21, w14), SeriesPair::new(w14, w21), SeriesPair::new(w26, w0), SeriesPair::new(w28, w21), SeriesPair::new(k as f64 * w21, 0.0)], [SeriesPair::new(w22, w22), SeriesPair::new(w14, w21), SeriesPair::new(w21, w25), SeriesPair::new(w27, w31), SeriesPair::new(w31, 0.0)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let e1 = lanes1.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w3 = v2 * w0;
    let w8 = e0[1].both()[1] * per_k + w3 * v7;
    let w11 = e0[2].both()[1] * per_k + w3 * v10;
    let w13 = e0[3].both()[0] + 2.0 * v0 * w0;
    let w14 = e0[3].both()[1] * per_k + w0 * v15;
    let w18 = v17 * w14;
    let w20 = w13;
    let w21 = w20 + w18;
    let w22 = (0.0 - e1[0].both()[0] - v22 * w21) * per22;
    let w23 = v12 * w22;
    let w24 = e1[0].both()[1] + v14 * w22 + w14 * v22;
    let w25 = e1[1].both()[0] + 2.0 * v14 * w14;
    let w26 = e1[1].both()[1] + 2.0 * v21 * w21;
    let w27 = e1[2].both()[0] + v26 * w21 + w26 * v21;
    let w28 = e1[2].both()[1] + v0 * w25 + w0 * v25;
    let w29 = e1[3].both()[0] + v28 * w27 + w28 * v27;
    let w31 = ((v30 + 1.0) * e1[4].both()[0] * per_k - e1[3].both()[1] + v30 * v31 * w21) * per31;
    out.guards[0][k] = w8;
    out.guards[1][k] = w11;
    out.guards[2][k] = w23;
    out.guards[3][k] = w24;
    out.guards[4][k] = w29;
    out.guards[5][k] = w31;
}

/// Six functions of x.
#[rustfmt::skip]
pub(super) fn functions3(
    c: &[f64; 1],
    _s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 1]>,
) {
    let x = out.terms[0];
    let v0 = x[0];
    let v1 = 1.0_f64;
    let v2 = v0 * v0;
    let (v3, v4) = math::sin_cos(v0);
    let v6 = 0.3_f64;
    let v7 = v6 * v3;
    let v8 = 1.2000000000000002_f64;
    let v9 = v8 + v2;
    let v10 = v9 + v7;
    let v11 = c[0];
    let v12 = math::powf(v10, v11);
    let v13 = v1 / v10;
    let v14 = math::ln(v10);
    let v15 = v3 * v14;
    let v16 = math::exp(v15);
    let v17 = v10 * v10;
    let v18 = v3 * v3;
    let v19 = v17 + v18;
    let v20 = v10 / v19;
    let v21 = v3 / v19;
    let v23 = 0.0_f64;
    let v24 = 0.0_f64;
    let v25 = math::atan2(v3, v10);
    let v26 = v18 + v17;
    let v27 = math::hypot(v3, v10);
    let v28 = v3 - v10;
    let v29 = if v28 > 0.0 { v10 } else { v3 };
    let v30 = if v28 > 0.0 { v3 } else { v10 };
    let per12 = 1.0 / v10;
    let per13 = 1.0 / v10;
    let per20 = 1.0 / v19;
    let per21 = 1.0 / v19;
    let per27 = 0.5 / v27;
    let is29 = v28 > 0.0;
    let is30 = v28 > 0.0;
    let mut lanes0 = SeriesLanes::<4>::ZERO;
    let mut lanes1 = SeriesLanes::<4>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v1];
    out.guards[0][0] = v12;
    out.guards[1][0] = v16;
    out.guards[2][0] = v25;
    out.guards[3][0] = v27;
    out.guards[4][0] = v29;
    out.guards[5][0] = v30;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let e1 = lanes1.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w2 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w3 = e0[0].both()[1] * per_k + w0 * v4;
        let w4 = -(e0[1].both()[0] * per_k + w0 * v3);
        let w7 = v6 * w3;
        let w9 = w2;
        let w10 = w9 + w7;
        let w12 = ((v11 + 1.0) * e0[2].both()[0] * per_k - e0[1].both()[1] + v11 * v12 * w10) * per12;
        let w13 = (0.0 - e0[2].both()[1] - v13 * w10) * per13;
        let w14 = e0[3].both()[0] * per_k + w10 * v13;
        let w15 = e0[3].both()[1] + v3 * w14 + w3 * v14;
        let w16 = e1[0].both()[0] * per_k + w15 * v16;
        let w17 = e1[0].both()[1] + 2.0 * v10 * w10;
        let w18 = e1[1].both()[0] + 2.0 * v3 * w3;
        let w19 = w17 + w18;
        let w20 = (w10 - e1[1].both()[1] - v20 * w19) * per20;
        let w21 = (w3 - e1[2].both()[0] - v21 * w19) * per21;
        let w23 = e1[2].both()[1] * per_k + w3 * v20;
        let w24 = e1[3].both()[0] * per_k + w10 * v21;
        let w25 = w23 - w24;
        let w26 = w18 + w17;
        let w27 = (w26 - e1[3].both()[1]) * per27;
        let w29 = if is29 { w10 } else { w3 };
        let w30 = if is30 { w3 } else { w10 };
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w12;
        out.guards[1][k] = w16;
        out.guards[2][k] = w25;
        out.guards[3][k] = w27;
        out.guards[4][k] = w29;
        out.guards[5][k] = w30;
        lanes0.enter(k, [SeriesPair::new(w0, k as f64 * w0), SeriesPair::new(k as f64 * w0, w10), SeriesPair::new(k as f64 * w10, w10), SeriesPair::new(k as f64 * w10, w3)], [SeriesPair::new(w0, w4), SeriesPair::new(w3, w12), SeriesPair::new(w12, w13), SeriesPair::new(w13, w14)]);
        lanes1.enter(k, [SeriesPair::new(k as f64 * w15, w10), SeriesPair::new(w3, w19), SeriesPair::new(w19, k as f64 * w3), SeriesPair::new(k as f64 * w10, w27)], [SeriesPair::new(w16, w10), SeriesPair::new(w3, w20), SeriesPair::new(w21, w20), SeriesPair::new(w21, w27)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let e1 = lanes1.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w2 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w3 = e0[0].both()[1] * per_k + w0 * v4;
    let w7 = v6 * w3;
    let w9 = w2;
    let w10 = w9 + w7;
    let w12 = ((v11 + 1.0) * e0[2].both()[0] * per_k - e0[1].both()[1] + v11 * v12 * w10) * per12;
    let w14 = e0[3].both()[0] * per_k + w10 * v13;
    let w15 = e0[3].both()[1] + v3 * w14 + w3 * v14;
    let w16 = e1[0].both()[0] * per_k + w15 * v16;
    let w17 = e1[0].both()[1] + 2.0 * v10 * w10;
    let w18 = e1[1].both()[0] + 2.0 * v3 * w3;
    let w23 = e1[2].both()[1] * per_k + w3 * v20;
    let w24 = e1[3].both()[0] * per_k + w10 * v21;
    let w25 = w23 - w24;
    let w26 = w18 + w17;
    let w27 = (w26 - e1[3].both()[1]) * per27;
    let w29 = if is29 { w10 } else { w3 };
    let w30 = if is30 { w3 } else { w10 };
    out.guards[0][k] = w12;
    out.guards[1][k] = w16;
    out.guards[2][k] = w25;
    out.guards[3][k] = w27;
    out.guards[4][k] = w29;
    out.guards[5][k] = w30;
}

/// Six functions of x.
#[rustfmt::skip]
pub(super) fn functions4(
    c: &[f64; 1],
    _s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 1]>,
) {
    let x = out.terms[0];
    let v0 = x[0];
    let v1 = 1.0_f64;
    let v2 = c[0];
    let v3 = v0 * v0;
    let (v4, v5) = math::sin_cos(v0);
    let v7 = 0.3_f64;
    let v8 = v7 * v4;
    let v9 = 1.2000000000000002_f64;
    let v10 = v9 + v3;
    let v11 = v10 + v8;
    let v12 = v11 * v11;
    let v13 = v2 * v2;
    let v14 = v12 + v13;
    let v16 = v2 / v14;
    let v18 = 0.0_f64;
    let v19 = math::atan2(v2, v11);
    let v20 = if v4 > 0.0 { v11 } else { v0 };
    let v21 = if v0 > 0.0 { v2 } else { v0 };
    let per16 = 1.0 / v14;
    let is20 = v4 > 0.0;
    let is21 = v0 > 0.0;
    let mut lanes0 = SeriesLanes::<3>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v1];
    out.guards[0][0] = v19;
    out.guards[1][0] = v20;
    out.guards[2][0] = v21;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w3 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w4 = e0[0].both()[1] * per_k + w0 * v5;
        let w5 = -(e0[1].both()[0] * per_k + w0 * v4);
        let w8 = v7 * w4;
        let w10 = w3;
        let w11 = w10 + w8;
        let w12 = e0[1].both()[1] + 2.0 * v11 * w11;
        let w14 = w12;
        let w16 = (0.0 - e0[2].both()[0] - v16 * w14) * per16;
        let w18 = e0[2].both()[1] * per_k + w11 * v16;
        let w19 = -w18;
        let w20 = if is20 { w11 } else { w0 };
        let w21 = if is21 { 0.0 } else { w0 };
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w19;
        out.guards[1][k] = w20;
        out.guards[2][k] = w21;
        lanes0.enter(k, [SeriesPair::new(w0, k as f64 * w0), SeriesPair::new(k as f64 * w0, w11), SeriesPair::new(w14, k as f64 * w11)], [SeriesPair::new(w0, w5), SeriesPair::new(w4, w11), SeriesPair::new(w16, w16)]);
    }
    out.known_guards = 3;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w3 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w4 = e0[0].both()[1] * per_k + w0 * v5;
    let w8 = v7 * w4;
    let w10 = w3;
    let w11 = w10 + w8;
    let w18 = e0[2].both()[1] * per_k + w11 * v16;
    let w19 = -w18;
    let w20 = if is20 { w11 } else { w0 };
    let w21 = if is21 { 0.0 } else { w0 };
    out.guards[0][k] = w19;
    out.guards[1][k] = w20;
    out.guards[2][k] = w21;
}
