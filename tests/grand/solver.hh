// DOP853 with the closing and opening of contacts located.
#pragma once
#include "grand.hh"
#include "dop853.hh"

struct EventLog { double t; std::string name; Vec y; };

struct Solver {
    Model& m;
    Signal input;
    double rtol = 1e-8, atol = 1e-10, hmax = 1e-3;
    unsigned locate = 1u << STRING | 1u << BED;
    double t = 0; Vec y{}; unsigned closed = 0;
    double h = 1e-5; long evals = 0;
    std::vector<EventLog> events;
    std::function<void(double, const Vec&, const Model::Eval&)> on_step;

    Solver(Model& mm, Signal in) : m(mm), input(in) {}

    unsigned mask() const { return closed | ~locate; }
    void f(double tt, const Vec& yy, Vec& dy) {
        Model::Eval e; evals++;
        m.eval(yy.data(), input(tt), mask(), e);
        for (int i = 0; i < 5; i++) { dy[i] = yy[5 + i]; dy[5 + i] = e.accel[i]; }
        for (int i = 0; i < 3; i++) dy[10 + i] = e.zrate[i];
    }
    double step(double hh, Vec& out) {
        Vec k[12];
        f(t, y, k[0]);
        for (int s = 1; s < 12; s++) {
            Vec z = y;
            for (int j = 0; j < s; j++) if (DA[s][j] != 0) for (int i = 0; i < NS; i++) z[i] += hh * DA[s][j] * k[j][i];
            f(t + DC[s] * hh, z, k[s]);
        }
        out = y; double e5 = 0, e3 = 0;
        for (int i = 0; i < NS; i++) {
            double b = 0, a3 = 0, a5 = 0;
            for (int s = 0; s < 12; s++) { b += DB[s] * k[s][i]; a3 += DE3[s] * k[s][i]; a5 += DE5[s] * k[s][i]; }
            out[i] += hh * b;
            double at = i < 5 ? atol : i < 10 ? atol * 1e3 : atol * 1e4;
            double sc = at + rtol * std::max(std::abs(y[i]), std::abs(out[i]));
            e3 += a3 * a3 / sc / sc; e5 += a5 * a5 / sc / sc;
        }
        if (e5 == 0 && e3 == 0) return 0;
        return std::abs(hh) * e5 / std::sqrt((e5 + 0.01 * e3) * NS);
    }
    // What changes its sign where the equations have a corner: a gap, or what a loss or a friction
    // takes the magnitude of. Corners from NC on are located only where exact is set.
    bool exact = false;
    static constexpr int CORNERS = NC + NC + 2 + 4;
    double corner(int id, const Vec& z, const Model::Eval& e) const {
        if (id < NC) return e.pt.gap[id];
        if (id < 2 * NC) return (closed >> (id - NC) & 1) && id - NC != STRING ? e.pt.rate[id - NC] : 1;
        if (id == 2 * NC) return z[5];
        if (id == 2 * NC + 1) return closed >> CHECK & 1 ? e.pt.slip : 1;
        if (id == 2 * NC + 2) return beyond(z);
        if (id == 2 * NC + 5) return z[9];
        double x = (m.P.front * sin(z[0]) - m.P.damper_lift) / m.P.damper_soft;
        return id == 2 * NC + 3 ? x : x - 1;
    }
    double beyond(const Vec& z) const {
        V2 kn = rot(z[4], KN_H.x, KN_H.y), pj = rot(z[1], m.PJ().x, m.PJ().y);
        V2 d{HP.x + kn.x - WP.x - pj.x, HP.y + kn.y - WP.y - pj.y};
        return cos(z[2]) * d.x + sin(z[2]) * d.y - m.P.edge;
    }
    double corner_at(int id, double tt, const Vec& z) { Model::Eval e; evals++; m.eval(z.data(), input(tt), mask(), e); return corner(id, z, e); }
    void start(const Vec& y0) {
        y = y0; Point pt; m.gaps(y.data(), y.data() + 5, pt);
        closed = 0; for (int c = 0; c < NC; c++) if (pt.gap[c] < 0) closed |= 1u << c;
    }
    int last = -1; double last_t = -1;
    void run(double until) {
        while (t < until - 1e-15) {
            double hh = std::min({h, hmax, until - t});
            Vec out; double err = step(hh, out);
            if (!(err <= 1)) { h = hh * std::max(0.2, 0.9 * std::pow(err, -0.125)); if (!(h > 1e-15)) { fprintf(stderr, "step too small at %g\n", t); return; } continue; }
            double grow = err == 0 ? 5 : std::min(5.0, 0.9 * std::pow(err, -0.125));
            Model::Eval e0, e1;
            m.eval(y.data(), input(t), mask(), e0); m.eval(out.data(), input(t + hh), mask(), e1);
            double best = 2; int who = -1;
            for (int id = 0; id < (exact ? CORNERS : NC); id++) {
                if (id < NC && !(locate >> id & 1)) continue;
                double v0 = corner(id, y, e0), v1 = corner(id, out, e1);
                double sign;
                if (id < NC) { sign = closed >> id & 1 ? -1 : 1; if (sign * v1 >= 0) continue; v0 *= sign; v1 *= sign; }
                else { if (id == last && t - last_t < 1e-12) continue; if (!((v0 > 0 && v1 < 0) || (v0 < 0 && v1 > 0))) continue; sign = v0 > 0 ? 1 : -1; v0 *= sign; v1 *= sign; }
                double a = 0, b = 1, fa = v0, fb = v1;
                if (v0 <= 0) {  // just changed: look for the way back
                    Vec z; double x = 1e-3; step(hh * x, z); double vm = sign * corner_at(id, t + hh * x, z);
                    if (vm <= 0) { if (id < NC && !(t - last_t < 1e-12 && id == last)) { best = 0; who = id; } continue; }
                    a = x; fa = vm;
                }
                int side = 0;
                for (int it = 0; it < 60 && (b - a) * hh > 1e-17; it++) {
                    double x = (fa * b - fb * a) / (fa - fb);
                    if (it > 30 || !(x > a && x < b)) x = .5 * (a + b);
                    if (!(x > a && x < b)) break;
                    Vec z; step(hh * x, z); double v = sign * corner_at(id, t + hh * x, z);
                    if (v < 0) { b = x; fb = v; if (side == -1) fa *= .5; side = -1; }
                    else { a = x; fa = v; if (side == 1) fb *= .5; side = 1; if (v == 0) { b = x; break; } }
                }
                if (b < best) { best = b; who = id; }
            }
            if (who < 0) { y = out; t += hh; h = hh * grow; }
            else {
                if (best > 0) { step(hh * best, out); y = out; t += hh * best; }
                if (who < NC) {
                    bool close = !(closed >> who & 1); closed ^= 1u << who;
                    events.push_back({t, std::string(CONTACT_NAMES[who]) + (close ? "" : "-off"), y});
                }
                last = who; last_t = t; h = exact ? std::max(1e-7, hh * 0.3) : hh;
            }
            if (on_step) { Model::Eval e; m.eval(y.data(), input(t), mask(), e); on_step(t, y, e); }
        }
    }
    void recheck() {}
    void knot() { h = 1e-6; }
};

// Equilibrium with the finger at s and frictions unwound: a damped run, then Newton.
inline Vec rest(Params P, double s = 0) {
    Params D = P; D.t_pin = 0; D.t_flange = 0; D.mu_check = 0; D.b_hammer = 2e-3; D.b_jack = 5e-4; D.b_lever = 5e-4; D.b_whippen = 2e-3;
    Model m{D};
    auto f = [&](const Vec& y, double* a) { Model::Eval e; m.eval(y.data(), Input{s, 0}, ~0u, e); for (int i = 0; i < 5; i++) a[i] = e.accel[i]; };
    Vec y{}; double tt = 0, h = 1e-4;
    for (; tt < 0.7; tt += h) {  // RK4
        auto d = [&](const Vec& z) { Vec r{}; double a[5]; f(z, a); for (int i = 0; i < 5; i++) { r[i] = z[5 + i]; r[5 + i] = a[i]; } return r; };
        Vec k1 = d(y), z{}; for (int i = 0; i < 10; i++) z[i] = y[i] + h / 2 * k1[i];
        Vec k2 = d(z); for (int i = 0; i < 10; i++) z[i] = y[i] + h / 2 * k2[i];
        Vec k3 = d(z); for (int i = 0; i < 10; i++) z[i] = y[i] + h * k3[i];
        Vec k4 = d(z); for (int i = 0; i < 10; i++) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    for (int i = 5; i < NS; i++) y[i] = 0;
    for (int it = 0; it < 30; it++) {
        double a[5], J[5][6]; f(y, a);
        for (int j = 0; j < 5; j++) { Vec z = y; double d = 1e-8; z[j] += d; double b[5]; f(z, b); Vec z2 = y; z2[j] -= d; double c[5]; f(z2, c); for (int i = 0; i < 5; i++) J[i][j] = (b[i] - c[i]) / (2 * d); }
        for (int i = 0; i < 5; i++) J[i][5] = -a[i];
        for (int c = 0; c < 5; c++) { int p = c; for (int r = c; r < 5; r++) if (std::abs(J[r][c]) > std::abs(J[p][c])) p = r; for (int k = 0; k < 6; k++) std::swap(J[c][k], J[p][k]);
            for (int r = 0; r < 5; r++) if (r != c) { double q = J[r][c] / J[c][c]; for (int k = c; k < 6; k++) J[r][k] -= q * J[c][k]; } }
        double mx = 0; for (int i = 0; i < 5; i++) { double d = J[i][5] / J[i][i]; y[i] += d; mx = std::max(mx, std::abs(d)); }
        if (mx < 1e-16) break;
    }
    return y;
}
