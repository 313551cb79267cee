//! Written by `UPDATE=1 cargo test -p kane --test all taylor`; not by hand.

#![expect(clippy::pedantic, unused_variables, reason = "generated")]

use equations::functions;
use pode::series::lanes::{LanePair, ProductLanes};
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
    let v5 = 1.2000000000000002_f64;
    let v6 = v5 + v1;
    let v7 = 0.3_f64;
    let v8 = v7 * v2;
    let v9 = v6 + v8;
    let (v10, v11) = math::sin_cos(v9);
    let v13 = 1.0_f64;
    let v14 = math::tanh(v9);
    let v15 = v14 * v14;
    let v16 = v13 - v15;
    let v17 = math::exp(v9);
    let v18 = v13 / v9;
    let v19 = math::ln(v9);
    let v20 = math::sqrt(v9);
    let per18 = 1.0 / v9;
    let per20 = 0.5 / v20;
    let mut lanes0 = ProductLanes::<6>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v13];
    out.guards[0][0] = v10;
    out.guards[1][0] = v11;
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
        let w6 = w1;
        let w8 = v7 * w2;
        let w9 = w6 + w8;
        let w10 = e0[1].both()[1] * per_k + w9 * v11;
        let w11 = -(e0[2].both()[0] * per_k + w9 * v10);
        let w14 = e0[2].both()[1] * per_k + w9 * v16;
        let w15 = e0[3].both()[0] + 2.0 * v14 * w14;
        let w16 = -w15;
        let w17 = e0[3].both()[1] * per_k + w9 * v17;
        let w18 = (0.0 - e0[4].both()[0] - v18 * w9) * per18;
        let w19 = e0[4].both()[1] * per_k + w9 * v18;
        let w20 = (w9 - e0[5].both()[0]) * per20;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w10;
        out.guards[1][k] = w11;
        out.guards[2][k] = w14;
        out.guards[3][k] = w17;
        out.guards[4][k] = w19;
        out.guards[5][k] = w20;
        lanes0.enter(k, [LanePair::new(w0, k as f64 * w0), LanePair::new(k as f64 * w0, k as f64 * w9), LanePair::new(k as f64 * w9, k as f64 * w9), LanePair::new(w14, k as f64 * w9), LanePair::new(w9, k as f64 * w9), LanePair::new(w20, 0.0)], [LanePair::new(w0, w3), LanePair::new(w2, w11), LanePair::new(w10, w16), LanePair::new(w14, w17), LanePair::new(w18, w18), LanePair::new(w20, 0.0)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w1 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w2 = e0[0].both()[1] * per_k + w0 * v3;
    let w6 = w1;
    let w8 = v7 * w2;
    let w9 = w6 + w8;
    let w10 = e0[1].both()[1] * per_k + w9 * v11;
    let w11 = -(e0[2].both()[0] * per_k + w9 * v10);
    let w14 = e0[2].both()[1] * per_k + w9 * v16;
    let w17 = e0[3].both()[1] * per_k + w9 * v17;
    let w19 = e0[4].both()[1] * per_k + w9 * v18;
    let w20 = (w9 - e0[5].both()[0]) * per20;
    out.guards[0][k] = w10;
    out.guards[1][k] = w11;
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
    let v1 = v0 * v0;
    let (v2, v3) = math::sin_cos(v0);
    let v5 = 1.2000000000000002_f64;
    let v6 = v5 + v1;
    let v7 = 0.3_f64;
    let v8 = v7 * v2;
    let v9 = v6 + v8;
    let v10 = v9.abs();
    let v11 = functions::sign(v9);
    let v12 = functions::logistic(v9);
    let v13 = v12 * v12;
    let v14 = v12 - v13;
    let v15 = functions::softplus(v9);
    let v16 = functions::softplus_area(v9);
    let v17 = v15 * v15;
    let v18 = functions::softplus_square_area(v9);
    let v19 = 1.0_f64;
    let sign10 = functions::sign(v9);
    let mut lanes0 = ProductLanes::<5>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v19];
    out.guards[0][0] = v10;
    out.guards[1][0] = v11;
    out.guards[2][0] = v15;
    out.guards[3][0] = v12;
    out.guards[4][0] = v16;
    out.guards[5][0] = v18;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w1 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w2 = e0[0].both()[1] * per_k + w0 * v3;
        let w3 = -(e0[1].both()[0] * per_k + w0 * v2);
        let w6 = w1;
        let w8 = v7 * w2;
        let w9 = w6 + w8;
        let w10 = sign10 * w9;
        let w12 = e0[1].both()[1] * per_k + w9 * v14;
        let w13 = e0[2].both()[0] + 2.0 * v12 * w12;
        let w14 = w12 - w13;
        let w15 = e0[2].both()[1] * per_k + w9 * v12;
        let w16 = e0[3].both()[0] * per_k + w9 * v15;
        let w17 = e0[3].both()[1] + 2.0 * v15 * w15;
        let w18 = e0[4].both()[0] * per_k + w9 * v17;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w10;
        out.guards[1][k] = 0.0;
        out.guards[2][k] = w15;
        out.guards[3][k] = w12;
        out.guards[4][k] = w16;
        out.guards[5][k] = w18;
        lanes0.enter(k, [LanePair::new(w0, k as f64 * w0), LanePair::new(k as f64 * w0, k as f64 * w9), LanePair::new(w12, k as f64 * w9), LanePair::new(k as f64 * w9, w15), LanePair::new(k as f64 * w9, 0.0)], [LanePair::new(w0, w3), LanePair::new(w2, w14), LanePair::new(w12, w12), LanePair::new(w15, w15), LanePair::new(w17, 0.0)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w1 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w2 = e0[0].both()[1] * per_k + w0 * v3;
    let w6 = w1;
    let w8 = v7 * w2;
    let w9 = w6 + w8;
    let w10 = sign10 * w9;
    let w12 = e0[1].both()[1] * per_k + w9 * v14;
    let w15 = e0[2].both()[1] * per_k + w9 * v12;
    let w16 = e0[3].both()[0] * per_k + w9 * v15;
    let w18 = e0[4].both()[0] * per_k + w9 * v17;
    out.guards[0][k] = w10;
    out.guards[1][k] = 0.0;
    out.guards[2][k] = w15;
    out.guards[3][k] = w12;
    out.guards[4][k] = w16;
    out.guards[5][k] = w18;
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
    let v1 = c[0];
    let v2 = 0.5_f64;
    let v3 = v2 * v0;
    let v4 = v0 * v0;
    let (v5, v6) = math::sin_cos(v0);
    let v8 = 1.2000000000000002_f64;
    let v9 = v8 + v4;
    let v10 = 0.3_f64;
    let v11 = v10 * v5;
    let v12 = v9 + v11;
    let v13 = 1.0_f64;
    let v14 = v3 * v3;
    let v15 = v13 - v14;
    let v16 = math::sqrt(v15);
    let v17 = v13 / v16;
    let v18 = v3.asin();
    let v19 = -1.0_f64;
    let v20 = v19 / v16;
    let v21 = v3.acos();
    let v22 = v1 / v12;
    let v23 = v5 / v12;
    let v24 = v5 * v5;
    let v25 = v0 * v24;
    let v26 = v12 * v12;
    let v27 = v26 * v12;
    let v28 = v25 * v27;
    let v29 = 2.5_f64;
    let v30 = math::powf(v12, v29);
    let per16 = 0.5 / v16;
    let per17 = 1.0 / v16;
    let per20 = 1.0 / v16;
    let per22 = 1.0 / v12;
    let per23 = 1.0 / v12;
    let per30 = 1.0 / v12;
    let mut lanes0 = ProductLanes::<5>::ZERO;
    let mut lanes1 = ProductLanes::<5>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v13];
    out.guards[0][0] = v18;
    out.guards[1][0] = v21;
    out.guards[2][0] = v22;
    out.guards[3][0] = v23;
    out.guards[4][0] = v28;
    out.guards[5][0] = v30;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let e1 = lanes1.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w3 = v2 * w0;
        let w4 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w5 = e0[0].both()[1] * per_k + w0 * v6;
        let w6 = -(e0[1].both()[0] * per_k + w0 * v5);
        let w9 = w4;
        let w11 = v10 * w5;
        let w12 = w9 + w11;
        let w14 = e0[1].both()[1] + 2.0 * v3 * w3;
        let w15 = -w14;
        let w16 = (w15 - e0[2].both()[0]) * per16;
        let w17 = (0.0 - e0[2].both()[1] - v17 * w16) * per17;
        let w18 = e0[3].both()[0] * per_k + w3 * v17;
        let w20 = (0.0 - e0[3].both()[1] - v20 * w16) * per20;
        let w21 = e0[4].both()[0] * per_k + w3 * v20;
        let w22 = (0.0 - e1[0].both()[0] - v22 * w12) * per22;
        let w23 = (w5 - e1[0].both()[1] - v23 * w12) * per23;
        let w24 = e1[1].both()[0] + 2.0 * v5 * w5;
        let w25 = e1[1].both()[1] + v0 * w24 + w0 * v24;
        let w26 = e1[2].both()[0] + 2.0 * v12 * w12;
        let w27 = e1[2].both()[1] + v26 * w12 + w26 * v12;
        let w28 = e1[3].both()[0] + v25 * w27 + w25 * v27;
        let w30 = ((v29 + 1.0) * e1[4].both()[0] * per_k - e1[3].both()[1] + v29 * v30 * w12) * per30;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w18;
        out.guards[1][k] = w21;
        out.guards[2][k] = w22;
        out.guards[3][k] = w23;
        out.guards[4][k] = w28;
        out.guards[5][k] = w30;
        lanes0.enter(k, [LanePair::new(w0, k as f64 * w0), LanePair::new(k as f64 * w0, w3), LanePair::new(w16, w16), LanePair::new(k as f64 * w3, w16), LanePair::new(k as f64 * w3, 0.0)], [LanePair::new(w0, w6), LanePair::new(w5, w3), LanePair::new(w16, w17), LanePair::new(w17, w20), LanePair::new(w20, 0.0)]);
        lanes1.enter(k, [LanePair::new(w12, w12), LanePair::new(w5, w0), LanePair::new(w12, w26), LanePair::new(w25, w12), LanePair::new(k as f64 * w12, 0.0)], [LanePair::new(w22, w23), LanePair::new(w5, w24), LanePair::new(w12, w12), LanePair::new(w27, w30), LanePair::new(w30, 0.0)]);
    }
    out.known_guards = 6;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let e1 = lanes1.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w3 = v2 * w0;
    let w4 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w5 = e0[0].both()[1] * per_k + w0 * v6;
    let w9 = w4;
    let w11 = v10 * w5;
    let w12 = w9 + w11;
    let w18 = e0[3].both()[0] * per_k + w3 * v17;
    let w21 = e0[4].both()[0] * per_k + w3 * v20;
    let w22 = (0.0 - e1[0].both()[0] - v22 * w12) * per22;
    let w23 = (w5 - e1[0].both()[1] - v23 * w12) * per23;
    let w24 = e1[1].both()[0] + 2.0 * v5 * w5;
    let w25 = e1[1].both()[1] + v0 * w24 + w0 * v24;
    let w26 = e1[2].both()[0] + 2.0 * v12 * w12;
    let w27 = e1[2].both()[1] + v26 * w12 + w26 * v12;
    let w28 = e1[3].both()[0] + v25 * w27 + w25 * v27;
    let w30 = ((v29 + 1.0) * e1[4].both()[0] * per_k - e1[3].both()[1] + v29 * v30 * w12) * per30;
    out.guards[0][k] = w18;
    out.guards[1][k] = w21;
    out.guards[2][k] = w22;
    out.guards[3][k] = w23;
    out.guards[4][k] = w28;
    out.guards[5][k] = w30;
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
    let v1 = c[0];
    let v2 = v0 * v0;
    let (v3, v4) = math::sin_cos(v0);
    let v6 = 1.2000000000000002_f64;
    let v7 = v6 + v2;
    let v8 = 0.3_f64;
    let v9 = v8 * v3;
    let v10 = v7 + v9;
    let v11 = math::powf(v10, v1);
    let v12 = 1.0_f64;
    let v13 = v12 / v10;
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
    let per11 = 1.0 / v10;
    let per13 = 1.0 / v10;
    let per20 = 1.0 / v19;
    let per21 = 1.0 / v19;
    let per27 = 0.5 / v27;
    let is29 = v28 > 0.0;
    let is30 = v28 > 0.0;
    let mut lanes0 = ProductLanes::<4>::ZERO;
    let mut lanes1 = ProductLanes::<4>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v12];
    out.guards[0][0] = v11;
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
        let w7 = w2;
        let w9 = v8 * w3;
        let w10 = w7 + w9;
        let w11 = ((v1 + 1.0) * e0[2].both()[0] * per_k - e0[1].both()[1] + v1 * v11 * w10) * per11;
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
        out.guards[0][k] = w11;
        out.guards[1][k] = w16;
        out.guards[2][k] = w25;
        out.guards[3][k] = w27;
        out.guards[4][k] = w29;
        out.guards[5][k] = w30;
        lanes0.enter(k, [LanePair::new(w0, k as f64 * w0), LanePair::new(k as f64 * w0, w10), LanePair::new(k as f64 * w10, w10), LanePair::new(k as f64 * w10, w3)], [LanePair::new(w0, w4), LanePair::new(w3, w11), LanePair::new(w11, w13), LanePair::new(w13, w14)]);
        lanes1.enter(k, [LanePair::new(k as f64 * w15, w10), LanePair::new(w3, w19), LanePair::new(w19, k as f64 * w3), LanePair::new(k as f64 * w10, w27)], [LanePair::new(w16, w10), LanePair::new(w3, w20), LanePair::new(w21, w20), LanePair::new(w21, w27)]);
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
    let w7 = w2;
    let w9 = v8 * w3;
    let w10 = w7 + w9;
    let w11 = ((v1 + 1.0) * e0[2].both()[0] * per_k - e0[1].both()[1] + v1 * v11 * w10) * per11;
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
    out.guards[0][k] = w11;
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
    let v1 = c[0];
    let v2 = v0 * v0;
    let (v3, v4) = math::sin_cos(v0);
    let v6 = 1.2000000000000002_f64;
    let v7 = v6 + v2;
    let v8 = 0.3_f64;
    let v9 = v8 * v3;
    let v10 = v7 + v9;
    let v11 = v10 * v10;
    let v12 = v1 * v1;
    let v13 = v11 + v12;
    let v15 = v1 / v13;
    let v17 = 0.0_f64;
    let v18 = math::atan2(v1, v10);
    let v19 = if v3 > 0.0 { v10 } else { v0 };
    let v20 = if v0 > 0.0 { v1 } else { v0 };
    let v21 = 1.0_f64;
    let per15 = 1.0 / v13;
    let is19 = v3 > 0.0;
    let is20 = v0 > 0.0;
    let mut lanes0 = ProductLanes::<3>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v21];
    out.guards[0][0] = v18;
    out.guards[1][0] = v19;
    out.guards[2][0] = v20;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w2 = e0[0].both()[0] + 2.0 * v0 * w0;
        let w3 = e0[0].both()[1] * per_k + w0 * v4;
        let w4 = -(e0[1].both()[0] * per_k + w0 * v3);
        let w7 = w2;
        let w9 = v8 * w3;
        let w10 = w7 + w9;
        let w11 = e0[1].both()[1] + 2.0 * v10 * w10;
        let w13 = w11;
        let w15 = (0.0 - e0[2].both()[0] - v15 * w13) * per15;
        let w17 = e0[2].both()[1] * per_k + w10 * v15;
        let w18 = -w17;
        let w19 = if is19 { w10 } else { w0 };
        let w20 = if is20 { 0.0 } else { w0 };
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * 0.0];
        out.guards[0][k] = w18;
        out.guards[1][k] = w19;
        out.guards[2][k] = w20;
        lanes0.enter(k, [LanePair::new(w0, k as f64 * w0), LanePair::new(k as f64 * w0, w10), LanePair::new(w13, k as f64 * w10)], [LanePair::new(w0, w4), LanePair::new(w3, w10), LanePair::new(w15, w15)]);
    }
    out.known_guards = 3;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w2 = e0[0].both()[0] + 2.0 * v0 * w0;
    let w3 = e0[0].both()[1] * per_k + w0 * v4;
    let w7 = w2;
    let w9 = v8 * w3;
    let w10 = w7 + w9;
    let w17 = e0[2].both()[1] * per_k + w10 * v15;
    let w18 = -w17;
    let w19 = if is19 { w10 } else { w0 };
    let w20 = if is20 { 0.0 } else { w0 };
    out.guards[0][k] = w18;
    out.guards[1][k] = w19;
    out.guards[2][k] = w20;
}
