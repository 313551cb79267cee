//! Taylor series of model B, written by `kane::taylor` from its equations; not by hand.
//!
//! `UPDATE=1 cargo test -p kane --test all taylor` writes it again.

#![expect(clippy::pedantic, reason = "generated")]

use pode::series::lanes::{LanePair, ProductLanes};
use pode::series::rows::PER_ORDER;
use pode::series::{Expansion, INPUT_TERMS};
use pode::{Motion, math};

/// B1 without a felt: derivative, release, string.
#[rustfmt::skip]
pub(super) fn coupled(
    c: &[f64; 10],
    s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 4]>,
) {
    let x = out.terms[0];
    let per_scale = 1.0 / out.scale;
    let v0 = c[0];
    let v1 = c[1];
    let v2 = c[2];
    let v3 = c[3];
    let v4 = c[4];
    let v5 = c[5];
    let v6 = c[6];
    let v7 = c[7];
    let v8 = c[8];
    let v9 = c[9];
    let v10 = x[0];
    let v11 = x[1];
    let (v12, v13) = math::sin_cos(v10);
    let (v15, v16) = math::sin_cos(v11);
    let v18 = v10 - v11;
    let (v19, v20) = math::sin_cos(v18);
    let v22 = x[2];
    let v23 = x[3];
    let v24 = s[0].position;
    let v25 = s[1].position * 1.0 * per_scale;
    let v26 = v24 - v11;
    let v27 = v25 - v23;
    let v28 = v3 * v13;
    let v29 = v4 * v16;
    let v30 = v7 * v26;
    let v31 = v8 * v27;
    let v32 = v0 * v19;
    let v33 = v2 * v13;
    let v34 = v1 * v12;
    let v35 = v34 - v32;
    let v36 = v35 - v33;
    let v37 = v9 - v10;
    let v38 = v1 * v16;
    let v39 = v2 * v15;
    let v40 = v0 - v38;
    let v41 = v40 - v39;
    let v42 = v20 * v20;
    let v43 = v0 * v42;
    let v44 = v19 * v36;
    let v45 = v43 - v44;
    let v46 = v5 * v36;
    let v47 = v46 * v41;
    let v48 = v42 * v20;
    let v49 = v47 / v48;
    let v50 = v6 * v36;
    let v51 = v50 * v45;
    let v52 = v51 / v48;
    let v53 = v49 - v28;
    let v54 = v30 + v31;
    let v55 = v54 - v29;
    let v56 = v55 - v52;
    let per49 = 1.0 / v48;
    let per52 = 1.0 / v48;
    let mut lanes0 = ProductLanes::<7>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v22, by * v23, by * v53, by * v56];
    out.guards[0][0] = v36;
    out.guards[1][0] = v37;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w10 = x[0];
        let w11 = x[1];
        let w12 = e0[0].both()[0] * per_k + w10 * v13;
        let w13 = -(e0[0].both()[1] * per_k + w10 * v12);
        let w15 = e0[1].both()[0] * per_k + w11 * v16;
        let w16 = -(e0[1].both()[1] * per_k + w11 * v15);
        let w18 = w10 - w11;
        let w19 = e0[2].both()[0] * per_k + w18 * v20;
        let w20 = -(e0[2].both()[1] * per_k + w18 * v19);
        let w22 = x[2];
        let w23 = x[3];
        let w24 = s[k].position;
        let w25 = s[k + 1].position * (k + 1) as f64 * per_scale;
        let w26 = w24 - w11;
        let w27 = w25 - w23;
        let w28 = v3 * w13;
        let w29 = v4 * w16;
        let w30 = v7 * w26;
        let w31 = v8 * w27;
        let w32 = v0 * w19;
        let w33 = v2 * w13;
        let w34 = v1 * w12;
        let w35 = w34 - w32;
        let w36 = w35 - w33;
        let w37 = -w10;
        let w38 = v1 * w16;
        let w39 = v2 * w15;
        let w40 = -w38;
        let w41 = w40 - w39;
        let w42 = e0[3].both()[0] + 2.0 * v20 * w20;
        let w43 = v0 * w42;
        let w44 = e0[3].both()[1] + v19 * w36 + w19 * v36;
        let w45 = w43 - w44;
        let w46 = v5 * w36;
        let w47 = e0[4].both()[0] + v46 * w41 + w46 * v41;
        let w48 = e0[4].both()[1] + v42 * w20 + w42 * v20;
        let w49 = (w47 - e0[5].both()[0] - v49 * w48) * per49;
        let w50 = v6 * w36;
        let w51 = e0[5].both()[1] + v50 * w45 + w50 * v45;
        let w52 = (w51 - e0[6].both()[0] - v52 * w48) * per52;
        let w53 = w49 - w28;
        let w54 = w30 + w31;
        let w55 = w54 - w29;
        let w56 = w55 - w52;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * w22, by * w23, by * w53, by * w56];
        out.guards[0][k] = w36;
        out.guards[1][k] = w37;
        lanes0.enter(k, [LanePair::new(k as f64 * w10, k as f64 * w10), LanePair::new(k as f64 * w11, k as f64 * w11), LanePair::new(k as f64 * w18, k as f64 * w18), LanePair::new(w20, w19), LanePair::new(w46, w42), LanePair::new(w48, w50), LanePair::new(w48, 0.0)], [LanePair::new(w13, w12), LanePair::new(w16, w15), LanePair::new(w20, w19), LanePair::new(w20, w36), LanePair::new(w41, w20), LanePair::new(w49, w45), LanePair::new(w52, 0.0)]);
    }
    out.known_guards = 2;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w10 = x[0];
    let w11 = x[1];
    let w12 = e0[0].both()[0] * per_k + w10 * v13;
    let w13 = -(e0[0].both()[1] * per_k + w10 * v12);
    let w18 = w10 - w11;
    let w19 = e0[2].both()[0] * per_k + w18 * v20;
    let w32 = v0 * w19;
    let w33 = v2 * w13;
    let w34 = v1 * w12;
    let w35 = w34 - w32;
    let w36 = w35 - w33;
    let w37 = -w10;
    out.guards[0][k] = w36;
    out.guards[1][k] = w37;
}

/// B2: derivative, landing, string.
#[rustfmt::skip]
pub(super) fn apart(
    c: &[f64; 10],
    s: &[Motion; INPUT_TERMS],
    out: &mut Expansion<[f64; 4]>,
) {
    let x = out.terms[0];
    let per_scale = 1.0 / out.scale;
    let v0 = c[0];
    let v1 = c[1];
    let v2 = c[2];
    let v3 = c[3];
    let v4 = c[4];
    let v5 = c[7];
    let v6 = c[8];
    let v7 = c[9];
    let v8 = x[0];
    let v9 = x[1];
    let (v10, v11) = math::sin_cos(v8);
    let v13 = v8 - v9;
    let (v14, v15) = math::sin_cos(v13);
    let (v17, v18) = math::sin_cos(v9);
    let v20 = x[2];
    let v21 = x[3];
    let v22 = s[0].position;
    let v23 = s[1].position * 1.0 * per_scale;
    let v24 = v22 - v9;
    let v25 = v23 - v21;
    let v26 = v3 * v11;
    let v27 = v4 * v18;
    let v28 = v5 * v24;
    let v29 = v6 * v25;
    let v30 = -v26;
    let v31 = v28 + v29;
    let v32 = v31 - v27;
    let v33 = v0 * v14;
    let v34 = v2 * v11;
    let v35 = v1 * v10;
    let v36 = v7 - v8;
    let v37 = v33 + v34;
    let v38 = v37 - v35;
    let mut lanes0 = ProductLanes::<3>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v20, by * v21, by * v30, by * v32];
    out.guards[0][0] = v38;
    out.guards[1][0] = v36;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w8 = x[0];
        let w9 = x[1];
        let w10 = e0[0].both()[0] * per_k + w8 * v11;
        let w11 = -(e0[0].both()[1] * per_k + w8 * v10);
        let w13 = w8 - w9;
        let w14 = e0[1].both()[0] * per_k + w13 * v15;
        let w15 = -(e0[1].both()[1] * per_k + w13 * v14);
        let w17 = e0[2].both()[0] * per_k + w9 * v18;
        let w18 = -(e0[2].both()[1] * per_k + w9 * v17);
        let w20 = x[2];
        let w21 = x[3];
        let w22 = s[k].position;
        let w23 = s[k + 1].position * (k + 1) as f64 * per_scale;
        let w24 = w22 - w9;
        let w25 = w23 - w21;
        let w26 = v3 * w11;
        let w27 = v4 * w18;
        let w28 = v5 * w24;
        let w29 = v6 * w25;
        let w30 = -w26;
        let w31 = w28 + w29;
        let w32 = w31 - w27;
        let w33 = v0 * w14;
        let w34 = v2 * w11;
        let w35 = v1 * w10;
        let w36 = -w8;
        let w37 = w33 + w34;
        let w38 = w37 - w35;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * w20, by * w21, by * w30, by * w32];
        out.guards[0][k] = w38;
        out.guards[1][k] = w36;
        lanes0.enter(k, [LanePair::new(k as f64 * w8, k as f64 * w8), LanePair::new(k as f64 * w13, k as f64 * w13), LanePair::new(k as f64 * w9, k as f64 * w9)], [LanePair::new(w11, w10), LanePair::new(w15, w14), LanePair::new(w18, w17)]);
    }
    out.known_guards = 2;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w8 = x[0];
    let w9 = x[1];
    let w10 = e0[0].both()[0] * per_k + w8 * v11;
    let w11 = -(e0[0].both()[1] * per_k + w8 * v10);
    let w13 = w8 - w9;
    let w14 = e0[1].both()[0] * per_k + w13 * v15;
    let w33 = v0 * w14;
    let w34 = v2 * w11;
    let w35 = v1 * w10;
    let w36 = -w8;
    let w37 = w33 + w34;
    let w38 = w37 - w35;
    out.guards[0][k] = w38;
    out.guards[1][k] = w36;
}
