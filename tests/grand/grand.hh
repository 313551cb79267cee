// An independent model of the grand action of grand.toml: Lagrange's equations in the absolute
// angles of the five bodies, derived by hand; felts as in the description's language.
// Angles are anticlockwise: k key, w whippen, j jack, l lever, h hammer.
#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>
#include <algorithm>

struct Params {
    double g = 9.81, front = 0.2595;
    double stick = 0.085, stick_c = -0.012, stick_j = 1.8e-3;  // mass, centre (x), inertia about it
    double leads = 0.055, leads_x = 0.150;
    double mw = 0.018, jw = 1.5e-5, mj = 0.003, jj = 1e-6, ml = 0.004, jl = 2e-6;
    double mh = 0.0087, shank = 0.130, ms = 0.005, cs = 0.055, js = 6e-6;
    double dip = 0.01016, button = 0.0626, jack_x = 0.099, edge = 0.0059, drop = 0.007;
    double string_height = 0.0475, check_x = 0.2325, check_y = 0.118, check_lean = 0.2;
    double k1 = 8000, b1 = 40;
    double k_bed = 2e7, k_rail = 2e7, k_capstan = 45e3, k_knuckle = 40e3, k_lever_pad = 5e7, k_cloth = 3e7, k_screw = 5e7, k_check = 2e7;
    double loss_string = 0.5;
    double hyst = 0.6, b_capstan = 40, b_knuckle = 40, n_soft = 1, wind_k = 2e-4, wind_c = 2e-4, lag = 4e-4, t_flange = 1.5e-3, wind_h = 1e-3, b_bed = 60, b_rail = 8, b_check = 10, b_cloth = 3;
    double Ks = 5e9, p = 2.4;
    double mu_check = 0.5;
    double k_jack = 0.02, t_jack = 0.006, k_lever = 0.1, t_lever = 0.032;
    double t_pin = 0.031;
    double b_hammer = 2e-5, b_jack = 1e-4, b_lever = 1e-4, b_whippen = 2e-5;
    double damper = 0.15, damper_lift = 0.005, damper_soft = 0.0005;
    double mu_jack = 0.0;
    double rail_pre = 0.16e-3, cap_pre = 0.03e-3, pad_pre = 0.063e-3, jack_clear = 0.0e-3;
    std::map<std::string, double*> names() {
        std::map<std::string, double*> m;
#define P(x) m[#x] = &x;
        P(g) P(front) P(stick) P(stick_c) P(stick_j) P(leads) P(leads_x) P(mw) P(jw) P(mj) P(jj) P(ml) P(jl)
        P(mh) P(shank) P(ms) P(cs) P(js) P(dip) P(button) P(jack_x) P(edge) P(drop) P(string_height)
        P(check_x) P(check_y) P(check_lean) P(k1) P(b1) P(k_bed) P(k_rail) P(k_capstan) P(k_knuckle)
        P(k_lever_pad) P(k_cloth) P(k_screw) P(k_check) P(loss_string) P(hyst) P(b_capstan) P(b_knuckle) P(n_soft) P(wind_k) P(wind_c) P(lag) P(t_flange) P(wind_h) P(b_bed) P(b_rail) P(b_check) P(b_cloth) P(Ks) P(p)
        P(mu_check) P(k_jack) P(t_jack) P(k_lever) P(t_lever) P(t_pin) P(b_hammer) P(b_jack) P(b_lever)
        P(b_whippen) P(damper) P(damper_lift) P(damper_soft) P(rail_pre) P(cap_pre) P(pad_pre) P(jack_clear)
#undef P
        return m;
    }
};

enum { BED, RAIL, CAPSTAN, JACK, JSTOP, JLIMIT, LETOFF, LEVER, LSTOP, DROP, HREST, STRING, CHECK, NC };
static const char* const CONTACT_NAMES[NC] = {"bed", "rail", "capstan", "jack", "jack_stop", "jack_limit", "let_off",
    "lever", "lever_stop", "drop_screw", "hammer_rest", "string", "check"};
constexpr int NS = 13;
using Vec = std::array<double, NS>;  // k w j l h, their rates, windings of pin, check and hammer flange
using Five = std::array<double, 5>;
struct V2 { double x, y; };
static inline V2 rot(double a, double x, double y) { double c = cos(a), s = sin(a); return {c * x - s * y, s * x + c * y}; }
static inline V2 perp(V2 v) { return {-v.y, v.x}; }
static inline double dot(V2 a, V2 b) { return a.x * b.x + a.y * b.y; }

// Geometry in metres.
static const V2 CAP_K{0.1385, 0.030}, WP{0.2035, 0.045}, HEEL_W{-0.065, -0.015}, LP_W{-0.0535, 0.020};
static const double FACE = 0.053, PAD = 0.038, LEVER_END = -0.054, KR = 0.005, BACK = 0.200;
static const V2 TOE_J{-0.025, 0.005}, HP{0.090, 0.118}, KN_H{0.0185, -0.010};
static const V2 CW{-0.055, 0.003}, CJ{-0.002, 0.025}, CL{-0.020, 0.036};
static const double TAIL_DX = 0.005, TAIL_Y = -0.025, REST_ANGLE = 0.03, SCREW_Y = 0.103;

struct Point { double gap[NC]; Five grad[NC]; double rate[NC]; double force[NC]; Five slip_grad; double slip; };

struct Input { double s, v; };
using Signal = std::function<Input(double)>;

struct Model {
    Params P;
    V2 PJ() const { return {-P.jack_x, 0.005}; }

    // Gaps and their gradients by the absolute angles (m, m/rad).
    void gaps(const double* q, const double* u, Point& o) const {
        double k = q[0], w = q[1], j = q[2], l = q[3], h = q[4];
        double ck = cos(k), sk = sin(k), cw = cos(w), sw = sin(w), cj = cos(j), sj = sin(j), cl = cos(l), sl = sin(l), ch = cos(h), sh = sin(h);
        auto R = [](double c, double s, V2 p) { return V2{c * p.x - s * p.y, s * p.x + c * p.y}; };
        for (int i = 0; i < NC; i++) o.grad[i].fill(0);
        double pressed = P.front * sk;
        o.gap[BED] = P.dip - pressed; o.grad[BED][0] = -P.front * ck;
        o.gap[RAIL] = BACK * sk - P.rail_pre; o.grad[RAIL][0] = BACK * ck;
        // Capstan under the heel: normal of the whippen.
        V2 cap = R(ck, sk, CAP_K);
        V2 rel{cap.x - WP.x, cap.y - WP.y};           // capstan from the whippen's pivot
        V2 nw{-sw, cw}, tw{cw, sw};
        o.gap[CAPSTAN] = HEEL_W.y - dot(nw, rel) - P.cap_pre;
        o.grad[CAPSTAN][0] = -dot(nw, perp(cap));
        o.grad[CAPSTAN][1] = dot(tw, rel);
        // Knuckle.
        V2 kn = R(ch, sh, KN_H), knd = perp(kn);
        V2 kna{HP.x + kn.x, HP.y + kn.y};
        V2 pj = R(cw, sw, PJ()), pjd = perp(pj);
        V2 d{kna.x - WP.x - pj.x, kna.y - WP.y - pj.y};
        V2 nj{-sj, cj}, tj{cj, sj};
        double over = dot(nj, d) - FACE, beyond = dot(tj, d) - P.edge;
        Five go{}, gb{};
        go[4] = dot(nj, knd); go[1] = -dot(nj, pjd); go[2] = -dot(tj, d);
        gb[4] = dot(tj, knd); gb[1] = -dot(tj, pjd); gb[2] = dot(nj, d);
        double past = beyond > 0 ? beyond : 0, r = std::sqrt(past * past + over * over);
        o.gap[JACK] = r - KR + P.jack_clear;
        for (int i = 0; i < 5; i++) o.grad[JACK][i] = (past * gb[i] + over * go[i]) / r;
        double thj = j - w, thl = l - w;
        o.gap[JSTOP] = 0.020 * thj; o.grad[JSTOP][2] = 0.020; o.grad[JSTOP][1] = -0.020;
        o.gap[JLIMIT] = 0.020 * (0.3 - thj); o.grad[JLIMIT][2] = -0.020; o.grad[JLIMIT][1] = 0.020;
        V2 toe = R(cj, sj, TOE_J);
        o.gap[LETOFF] = P.button - (WP.y + pj.y + toe.y); o.grad[LETOFF][1] = -pjd.y; o.grad[LETOFF][2] = -toe.x;
        // Repetition lever.
        V2 pl = R(cw, sw, LP_W), pld = perp(pl);
        V2 dl{kna.x - WP.x - pl.x, kna.y - WP.y - pl.y};
        V2 nl{-sl, cl}, tl{cl, sl};
        o.gap[LEVER] = dot(nl, dl) - PAD - KR - P.pad_pre;
        o.grad[LEVER][4] = dot(nl, knd); o.grad[LEVER][1] = -dot(nl, pld); o.grad[LEVER][3] = -dot(tl, dl);
        o.gap[LSTOP] = 0.040 * thl; o.grad[LSTOP][3] = 0.040; o.grad[LSTOP][1] = -0.040;
        V2 le = R(cl, sl, V2{LEVER_END, PAD});
        o.gap[DROP] = SCREW_Y + P.drop - (WP.y + pl.y + le.y); o.grad[DROP][1] = -pld.y; o.grad[DROP][3] = -le.x;
        o.gap[HREST] = P.shank * (h + REST_ANGLE); o.grad[HREST][4] = P.shank;
        o.gap[STRING] = P.string_height - P.shank * sh; o.grad[STRING][4] = -P.shank * ch;
        V2 tail = R(ch, sh, V2{P.shank + TAIL_DX, TAIL_Y}), taild = perp(tail);
        V2 chk = R(ck, sk, V2{P.check_x, P.check_y}), chkd = perp(chk);
        double cc = cos(P.check_lean), sc = sin(P.check_lean);
        V2 n{cc, -sc}, t{sc, cc};
        V2 dc{chk.x - HP.x - tail.x, chk.y - HP.y - tail.y};
        o.gap[CHECK] = dot(n, dc); o.grad[CHECK][0] = dot(n, chkd); o.grad[CHECK][4] = -dot(n, taild);
        o.slip_grad.fill(0); o.slip_grad[4] = dot(t, taild); o.slip_grad[0] = -dot(t, chkd);
        for (int c = 0; c < NC; c++) { double s = 0; for (int i = 0; i < 5; i++) s += o.grad[c][i] * u[i]; o.rate[c] = s; }
        double s = 0; for (int i = 0; i < 5; i++) s += o.slip_grad[i] * u[i]; o.slip = s;
    }

    void law(int c, double& k, double& n, double& loss) const {
        n = 2; loss = 0;
        switch (c) {
            case BED: k = P.k_bed; break;
            case RAIL: k = P.k_rail; break;
            case CAPSTAN: k = P.k_capstan; n = P.n_soft; break;
            case JACK: k = P.k_knuckle; n = P.n_soft; break;
            case LEVER: k = P.k_lever_pad; break;
            case DROP: k = P.k_screw; break;
            case HREST: k = P.k_rail; break;
            case STRING: k = P.Ks; n = P.p; loss = P.loss_string; break;
            case CHECK: k = P.k_check; break;
            default: k = P.k_cloth;
        }
    }
    // Viscous loss b of a felt (N s/m), up to the share hyst of its elastic force.
    double loss_of(int c) const {
        switch (c) {
            case BED: return P.b_bed;
            case RAIL: case HREST: return P.b_rail;
            case CAPSTAN: return P.b_capstan;
            case JACK: return P.b_knuckle;
            case CHECK: return P.b_check;
            default: return P.b_cloth;
        }
    }
    double felt(int c, double gap, double rate) const {
        if (gap >= 0) return 0;
        double k, n, loss; law(c, k, n, loss);
        double d = -gap;
        double e = k * (n == 2 ? d * d : n == 1 ? d : std::pow(d, n));
        if (c == STRING) return std::max(0.0, e * (1 - loss * rate));
        double b = loss_of(c), cap = P.hyst * e;
        return e * (1 - P.hyst * b * rate / (cap + b * std::abs(rate) + 1e-6));
    }

    struct Eval { Point pt; double F; double accel[5]; double zrate[3]; };

    // The derivative; closed: the contacts that may touch.
    void eval(const double* y, Input in, unsigned closed, Eval& e) const {
        const double *q = y, *u = y + 5;
        gaps(q, u, e.pt);
        for (int c = 0; c < NC; c++) e.pt.force[c] = (closed >> c & 1) ? felt(c, e.pt.gap[c], e.pt.rate[c]) : 0;
        Five Q{};
        for (int c = 0; c < NC; c++) if (e.pt.force[c] != 0) for (int i = 0; i < 5; i++) Q[i] += e.pt.force[c] * e.pt.grad[c][i];
        double k = q[0], w = q[1], j = q[2], l = q[3], h = q[4];
        double ck = cos(k), pressed = P.front * sin(k), dp = P.front * ck;
        double F = P.k1 * (in.s - pressed) + P.b1 * (in.v - dp * u[0]);
        e.F = F;
        Q[0] += F * dp;
        double x = (pressed - P.damper_lift) / P.damper_soft;
        Q[0] -= P.damper * std::min(1.0, std::max(0.0, x)) * dp;
        double thj = j - w, thl = l - w, thjd = u[2] - u[1], thld = u[3] - u[1];
        double tj = -(P.t_jack + P.k_jack * thj) - P.b_jack * thjd;
        double tl = -(P.t_lever + P.k_lever * thl) - P.b_lever * thld;
        Q[2] += tj; Q[1] -= tj;
        Q[3] += tl; Q[1] -= tl;
        Q[1] -= P.b_whippen * u[1]; Q[4] -= P.b_hammer * u[4];
        // Weights: -dV/dq, V = g sum m y.
        double g = P.g;
        V2 a;
        a = rot(k, P.stick_c, 0); Q[0] -= g * P.stick * a.x;
        a = rot(k, -P.leads_x, 0); Q[0] -= g * P.leads * a.x;
        V2 pj = rot(w, PJ().x, PJ().y), pl = rot(w, LP_W.x, LP_W.y), cw = rot(w, CW.x, CW.y);
        Q[1] -= g * (P.mw * cw.x + P.mj * pj.x + P.ml * pl.x);
        V2 cj = rot(j, CJ.x, CJ.y), cl = rot(l, CL.x, CL.y);
        Q[2] -= g * P.mj * cj.x; Q[3] -= g * P.ml * cl.x;
        double hm = P.mh * P.shank + P.ms * P.cs;
        Q[4] -= g * hm * cos(h);
        // T = 1/2 A w'^2 + 1/2 B j'^2 + m_j (pj.cj) w' j' + ...
        double Mk = P.stick_j + P.stick * P.stick_c * P.stick_c + P.leads * P.leads_x * P.leads_x;
        double Mh = P.mh * P.shank * P.shank + P.js + P.ms * P.cs * P.cs;
        double A = P.jw + P.mw * dot(CW, CW) + P.mj * dot(PJ(), PJ()) + P.ml * dot(LP_W, LP_W);
        double B = P.jj + P.mj * dot(CJ, CJ), C = P.jl + P.ml * dot(CL, CL);
        double bj = P.mj * dot(pj, cj), bl = P.ml * dot(pl, cl);
        // d(bj)/dw = m pj'.cj = m perp(pj).cj; d(bj)/dj = m pj.perp(cj) = -that.
        double dj = P.mj * dot(perp(pj), cj), dl = P.ml * dot(perp(pl), cl);
        // d/dt(dT/dw') = A w'' + bj j'' + (dj w' - dj j') j' ; - dT/dw = - dj w' j'.
        double rw = Q[1] + dj * u[2] * u[2] + dl * u[3] * u[3];
        double rj = Q[2] - dj * u[1] * u[1];
        double rl = Q[3] - dl * u[1] * u[1];
        // Dahl's frictions, wound up by zk and zc.
        double zk = y[10], zc = y[11];
        Q[0] -= P.t_pin * (P.wind_k * zk + P.lag * u[0]) / (P.wind_k + P.lag * std::abs(u[0]));
        e.zrate[0] = (u[0] - std::abs(u[0]) * zk) / (P.wind_k + P.lag * std::abs(u[0]));
        e.zrate[1] = (e.pt.slip - std::abs(e.pt.slip) * zc) / (P.wind_c + P.lag * std::abs(e.pt.slip));
        double deep = std::max(0.0, -e.pt.gap[CHECK]);
        if ((closed >> CHECK & 1) && deep > 0) {
            double fric = P.mu_check * P.k_check * deep * deep * (P.wind_c * zc + P.lag * e.pt.slip) / (P.wind_c + P.lag * std::abs(e.pt.slip)), wound = P.mu_check * P.wind_c * P.k_check * deep * zc * zc;
            for (int i = 0; i < 5; i += 4) Q[i] += -fric * e.pt.slip_grad[i] + wound * e.pt.grad[CHECK][i];
        }
        Q[4] -= P.t_flange * (P.wind_h * y[12] + P.lag * u[4]) / (P.wind_h + P.lag * std::abs(u[4]));
        e.zrate[2] = (u[4] - std::abs(u[4]) * y[12]) / (P.wind_h + P.lag * std::abs(u[4]));
        double S = A - bj * bj / B - bl * bl / C;
        e.accel[0] = Q[0] / Mk; e.accel[4] = Q[4] / Mh;
        e.accel[1] = (rw - bj / B * rj - bl / C * rl) / S;
        e.accel[2] = (rj - bj * e.accel[1]) / B; e.accel[3] = (rl - bl * e.accel[1]) / C;
    }

    double energy(const double* y, Input in) const {
        const double *q = y, *u = y + 5;
        Point pt; gaps(q, u, pt);
        double k = q[0], w = q[1], j = q[2], l = q[3], h = q[4];
        V2 pj = rot(w, PJ().x, PJ().y), pl = rot(w, LP_W.x, LP_W.y), cw = rot(w, CW.x, CW.y), cj = rot(j, CJ.x, CJ.y), cl = rot(l, CL.x, CL.y);
        double Mk = P.stick_j + P.stick * P.stick_c * P.stick_c + P.leads * P.leads_x * P.leads_x;
        double Mh = P.mh * P.shank * P.shank + P.js + P.ms * P.cs * P.cs;
        double A = P.jw + P.mw * dot(CW, CW) + P.mj * dot(PJ(), PJ()) + P.ml * dot(LP_W, LP_W);
        double B = P.jj + P.mj * dot(CJ, CJ), C = P.jl + P.ml * dot(CL, CL);
        double T = .5 * (Mk * u[0] * u[0] + Mh * u[4] * u[4] + A * u[1] * u[1] + B * u[2] * u[2] + C * u[3] * u[3]) + P.mj * dot(pj, cj) * u[1] * u[2] + P.ml * dot(pl, cl) * u[1] * u[3];
        double V = P.g * (P.stick * P.stick_c * sin(k) - P.leads * P.leads_x * sin(k) + P.mw * cw.y + P.mj * (pj.y + cj.y) + P.ml * (pl.y + cl.y) + (P.mh * P.shank + P.ms * P.cs) * sin(h));
        double thj = j - w, thl = l - w;
        V += P.t_jack * thj + .5 * P.k_jack * thj * thj + P.t_lever * thl + .5 * P.k_lever * thl * thl;
        double pr = P.front * sin(k); V += .5 * P.k1 * (in.s - pr) * (in.s - pr);
        double x = (pr - P.damper_lift) / P.damper_soft, c = std::min(1., std::max(0., x));
        V += P.damper * P.damper_soft * (c * c / 2 + std::max(0., x - 1));
        V += .5 * P.t_pin * P.wind_k * y[10] * y[10] + .5 * P.t_flange * P.wind_h * y[12] * y[12];
        if (pt.gap[CHECK] < 0) V += .5 * P.mu_check * P.wind_c * P.k_check * pt.gap[CHECK] * pt.gap[CHECK] * y[11] * y[11];
        for (int c = 0; c < NC; c++) if (pt.gap[c] < 0) { double kk, n, lo; law(c, kk, n, lo); V += kk * std::pow(-pt.gap[c], n + 1) / (n + 1); }
        return T + V;
    }
};
