//! Taylor series of model B, generated from its equations; a test compares the two.

#![expect(clippy::pedantic, reason = "generated")]

use pode::series::lanes::{SeriesLanes, SeriesPair};
use pode::series::PER_ORDER;
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
    let v0 = x[0];
    let v1 = x[1];
    let v2 = v0 - v1;
    let v3 = x[2];
    let v4 = x[3];
    let v5 = c[3];
    let (v6, v7) = math::sin_cos(v0);
    let v9 = v5 * v7;
    let v10 = c[5];
    let v11 = c[0];
    let v12 = c[1];
    let (v13, v14) = math::sin_cos(v1);
    let v16 = v12 * v14;
    let v17 = c[2];
    let v18 = v17 * v13;
    let v19 = v11 - v16;
    let v20 = v19 - v18;
    let (v21, v22) = math::sin_cos(v2);
    let v24 = 1.0_f64;
    let v25 = v24 / v22;
    let v26 = v11 * v21;
    let v27 = v17 * v7;
    let v28 = v12 * v6;
    let v29 = v28 - v27;
    let v30 = v29 - v26;
    let v31 = v30 * v25;
    let v32 = v25 * v31;
    let v33 = v25 * v32;
    let v34 = v10 * v20;
    let v35 = v34 * v33;
    let v36 = v35 - v9;
    let v37 = c[4];
    let v38 = v37 * v14;
    let v39 = c[7];
    let v40 = s[0].position;
    let v41 = v40 - v1;
    let v42 = v39 * v41;
    let v43 = c[8];
    let v44 = s[1].position * 1.0 * per_scale;
    let v45 = v44 - v4;
    let v46 = v43 * v45;
    let v47 = c[6];
    let v48 = v22 * v22;
    let v49 = v11 * v48;
    let v50 = v21 * v30;
    let v51 = v49 - v50;
    let v52 = v47 * v51;
    let v53 = v52 * v33;
    let v54 = v42 + v46;
    let v55 = v54 - v38;
    let v56 = v55 - v53;
    let v57 = c[9];
    let v58 = v57 - v0;
    let per25 = 1.0 / v22;
    let mut lanes0 = SeriesLanes::<7>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v3, by * v4, by * v36, by * v56];
    out.guards[0][0] = v30;
    out.guards[1][0] = v58;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w1 = x[1];
        let w2 = w0 - w1;
        let w3 = x[2];
        let w4 = x[3];
        let w6 = e0[0].both()[0] * per_k + w0 * v7;
        let w7 = -(e0[0].both()[1] * per_k + w0 * v6);
        let w9 = v5 * w7;
        let w13 = e0[1].both()[0] * per_k + w1 * v14;
        let w14 = -(e0[1].both()[1] * per_k + w1 * v13);
        let w16 = v12 * w14;
        let w18 = v17 * w13;
        let w19 = -w16;
        let w20 = w19 - w18;
        let w21 = e0[2].both()[0] * per_k + w2 * v22;
        let w22 = -(e0[2].both()[1] * per_k + w2 * v21);
        let w25 = (0.0 - e0[3].both()[0] - v25 * w22) * per25;
        let w26 = v11 * w21;
        let w27 = v17 * w7;
        let w28 = v12 * w6;
        let w29 = w28 - w27;
        let w30 = w29 - w26;
        let w31 = e0[3].both()[1] + v30 * w25 + w30 * v25;
        let w32 = e0[4].both()[0] + v25 * w31 + w25 * v31;
        let w33 = e0[4].both()[1] + v25 * w32 + w25 * v32;
        let w34 = v10 * w20;
        let w35 = e0[5].both()[0] + v34 * w33 + w34 * v33;
        let w36 = w35 - w9;
        let w38 = v37 * w14;
        let w40 = s[k].position;
        let w41 = w40 - w1;
        let w42 = v39 * w41;
        let w44 = s[k + 1].position * (k + 1) as f64 * per_scale;
        let w45 = w44 - w4;
        let w46 = v43 * w45;
        let w48 = e0[5].both()[1] + 2.0 * v22 * w22;
        let w49 = v11 * w48;
        let w50 = e0[6].both()[0] + v21 * w30 + w21 * v30;
        let w51 = w49 - w50;
        let w52 = v47 * w51;
        let w53 = e0[6].both()[1] + v52 * w33 + w52 * v33;
        let w54 = w42 + w46;
        let w55 = w54 - w38;
        let w56 = w55 - w53;
        let w58 = -w0;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * w3, by * w4, by * w36, by * w56];
        out.guards[0][k] = w30;
        out.guards[1][k] = w58;
        lanes0.enter(k, [SeriesPair::new(k as f64 * w0, k as f64 * w0), SeriesPair::new(k as f64 * w1, k as f64 * w1), SeriesPair::new(k as f64 * w2, k as f64 * w2), SeriesPair::new(w22, w30), SeriesPair::new(w25, w25), SeriesPair::new(w34, w22), SeriesPair::new(w21, w52)], [SeriesPair::new(w7, w6), SeriesPair::new(w14, w13), SeriesPair::new(w22, w21), SeriesPair::new(w25, w25), SeriesPair::new(w31, w32), SeriesPair::new(w33, w22), SeriesPair::new(w30, w33)]);
    }
    out.known_guards = 2;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w1 = x[1];
    let w2 = w0 - w1;
    let w6 = e0[0].both()[0] * per_k + w0 * v7;
    let w7 = -(e0[0].both()[1] * per_k + w0 * v6);
    let w21 = e0[2].both()[0] * per_k + w2 * v22;
    let w26 = v11 * w21;
    let w27 = v17 * w7;
    let w28 = v12 * w6;
    let w29 = w28 - w27;
    let w30 = w29 - w26;
    let w58 = -w0;
    out.guards[0][k] = w30;
    out.guards[1][k] = w58;
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
    let v0 = x[0];
    let v1 = x[1];
    let v2 = v0 - v1;
    let v3 = x[2];
    let v4 = x[3];
    let v5 = c[3];
    let (v6, v7) = math::sin_cos(v0);
    let v9 = v5 * v7;
    let v10 = -v9;
    let v11 = c[4];
    let (v12, v13) = math::sin_cos(v1);
    let v15 = v11 * v13;
    let v16 = c[7];
    let v17 = s[0].position;
    let v18 = v17 - v1;
    let v19 = v16 * v18;
    let v20 = c[8];
    let v21 = s[1].position * 1.0 * per_scale;
    let v22 = v21 - v4;
    let v23 = v20 * v22;
    let v24 = v19 + v23;
    let v25 = v24 - v15;
    let v26 = c[0];
    let (v27, v28) = math::sin_cos(v2);
    let v30 = v26 * v27;
    let v31 = c[2];
    let v32 = v31 * v7;
    let v33 = c[1];
    let v34 = v33 * v6;
    let v35 = v32 - v34;
    let v36 = v30 + v35;
    let v37 = c[9];
    let v38 = v37 - v0;
    let mut lanes0 = SeriesLanes::<3>::ZERO;
    let by = out.scale * PER_ORDER[1];
    out.terms[1] = [by * v3, by * v4, by * v10, by * v25];
    out.guards[0][0] = v36;
    out.guards[1][0] = v38;
    for k in 1..out.order {
        let x = out.terms[k];
        let e0 = lanes0.inner(k);
        let per_k = PER_ORDER[k];
        let w0 = x[0];
        let w1 = x[1];
        let w2 = w0 - w1;
        let w3 = x[2];
        let w4 = x[3];
        let w6 = e0[0].both()[0] * per_k + w0 * v7;
        let w7 = -(e0[0].both()[1] * per_k + w0 * v6);
        let w9 = v5 * w7;
        let w10 = -w9;
        let w12 = e0[1].both()[0] * per_k + w1 * v13;
        let w13 = -(e0[1].both()[1] * per_k + w1 * v12);
        let w15 = v11 * w13;
        let w17 = s[k].position;
        let w18 = w17 - w1;
        let w19 = v16 * w18;
        let w21 = s[k + 1].position * (k + 1) as f64 * per_scale;
        let w22 = w21 - w4;
        let w23 = v20 * w22;
        let w24 = w19 + w23;
        let w25 = w24 - w15;
        let w27 = e0[2].both()[0] * per_k + w2 * v28;
        let w28 = -(e0[2].both()[1] * per_k + w2 * v27);
        let w30 = v26 * w27;
        let w32 = v31 * w7;
        let w34 = v33 * w6;
        let w35 = w32 - w34;
        let w36 = w30 + w35;
        let w38 = -w0;
        let by = out.scale * PER_ORDER[k + 1];
        out.terms[k + 1] = [by * w3, by * w4, by * w10, by * w25];
        out.guards[0][k] = w36;
        out.guards[1][k] = w38;
        lanes0.enter(k, [SeriesPair::new(k as f64 * w0, k as f64 * w0), SeriesPair::new(k as f64 * w1, k as f64 * w1), SeriesPair::new(k as f64 * w2, k as f64 * w2)], [SeriesPair::new(w7, w6), SeriesPair::new(w13, w12), SeriesPair::new(w28, w27)]);
    }
    out.known_guards = 2;
    let k = out.order;
    let x = out.terms[k];
    let e0 = lanes0.inner(k);
    let per_k = PER_ORDER[k];
    let w0 = x[0];
    let w1 = x[1];
    let w2 = w0 - w1;
    let w6 = e0[0].both()[0] * per_k + w0 * v7;
    let w7 = -(e0[0].both()[1] * per_k + w0 * v6);
    let w27 = e0[2].both()[0] * per_k + w2 * v28;
    let w30 = v26 * w27;
    let w32 = v31 * w7;
    let w34 = v33 * w6;
    let w35 = w32 - w34;
    let w36 = w30 + w35;
    let w38 = -w0;
    out.guards[0][k] = w36;
    out.guards[1][k] = w38;
}
