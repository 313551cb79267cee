// The second code of the references in this folder: model B by extrapolation.
//
//     g++ -O2 model_b_stiff_check.cc -lquadmath -o check && ./check FACTOR T_END [MOST]
//
// Prints an event per line: time to 24 digits, guard, mode before and after. Gragg's method
// with Aitken-Neville extrapolation of fixed order 2 COLUMNS in 113 bits, over steps of a
// fixed part of a radian of the fastest oscillation; no dense output: a crossing that a step
// shows is closed in by integrating again from the step's start with a shorter step.
#include <quadmath.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

using Real = __float128;
using State = std::array<Real, 4>;

constexpr int COLUMNS = 12;
constexpr double RADIANS = 0.25;
// Steps of which each shows its guards at its end only are short beside any hop but these.
constexpr Real ZERO_BAND = 1e-28Q;

Real number(const char* text) { return strtoflt128(text, nullptr); }

struct ModelB {
    Real L1 = number("0.4"), L2 = number("1.0"), L3 = number("0.1"), L4 = number("0.05");
    Real M1 = number("6.5"), M2 = number("0.01"), cK = number("0.002");
    Real JK = number("0.01625"), JH = number("0.01"), g = number("9.81");
    Real string_angle = number("0.398"), k1, k2;

    explicit ModelB(Real factor) : k1(number("6.2") * factor), k2(number("15") * factor) {}

    Real s(Real t) const {
        const char* bells[3][3] = {{"0.099", "0.514", "0.079"},
                                   {"0.181", "1.095", "0.109"},
                                   {"0.186", "1.573", "0.059"}};
        Real sum = 0;
        for (auto& bell : bells) {
            Real z = (t - number(bell[1])) / number(bell[2]);
            sum += number(bell[0]) * expq(-z * z);
        }
        return sum;
    }

    Real gap(const State& x) const {
        return L4 * cosq(x[0]) - L3 * sinq(x[0]) - L1 * sinq(x[1] - x[0]);
    }

    State derivative(bool coupled, Real s, const State& x) const {
        Real on_hammer = -M2 * g * L2 * cosq(x[0]);
        Real on_key = k1 * (s - x[1]) - M1 * g * cK * cosq(x[1]);
        if (coupled) {
            Real delta = x[1] - x[0], c = cosq(delta);
            Real q4 = -gap(x) / c, q3 = (L1 - L3 * cosq(x[1]) - L4 * sinq(x[1])) / c;
            on_hammer += k2 * q4 * q3 / c;
            on_key -= k2 * q4 * (L1 + q4 * tanq(delta));
        }
        return {x[2], x[3], on_hammer / JH, on_key / JK};
    }

    // Positive while the mode is valid: the contact's guard, then the string's.
    Real guard(bool coupled, int which, const State& x) const {
        if (which == 1) return string_angle - x[0];
        return coupled ? -gap(x) / cosq(x[1] - x[0]) : gap(x);
    }
};

State plus(const State& x, Real a, const State& y) {
    State sum;
    for (int i = 0; i < 4; i++) sum[i] = x[i] + a * y[i];
    return sum;
}

State midpoint(const ModelB& m, bool coupled, Real t, const State& x, Real h, int n) {
    Real d = h / n;
    State before = x, now = plus(x, d, m.derivative(coupled, m.s(t), x));
    for (int i = 1; i < n; i++) {
        State next = plus(before, 2 * d, m.derivative(coupled, m.s(t + i * d), now));
        before = now;
        now = next;
    }
    return now;
}

State step(const ModelB& m, bool coupled, Real t, const State& x, Real h) {
    std::array<State, COLUMNS> row;
    for (int j = 0; j < COLUMNS; j++) {
        State fresh = midpoint(m, coupled, t, x, h, 2 * (j + 1));
        for (int k = 1; k <= j; k++) {
            Real r = Real(j + 1) / Real(j + 1 - k);
            State next = plus(fresh, 1 / (r * r - 1), plus(fresh, -1, row[k - 1]));
            row[k - 1] = fresh;
            fresh = next;
        }
        // `row` holds the last line of the tableau from left to right.
        row[j] = fresh;
    }
    return row[COLUMNS - 1];
}

State equilibrium(const ModelB& m) {
    State x = {-0.2Q, 0, 0, 0};
    const Real tiny = 1e-12Q;
    for (int round = 0; round < 60; round++) {
        State f = m.derivative(true, 0, x);
        State h = plus(m.derivative(true, 0, {x[0] + tiny, x[1], 0, 0}), -1,
                       m.derivative(true, 0, {x[0] - tiny, x[1], 0, 0}));
        State k = plus(m.derivative(true, 0, {x[0], x[1] + tiny, 0, 0}), -1,
                       m.derivative(true, 0, {x[0], x[1] - tiny, 0, 0}));
        Real a = h[2] / (2 * tiny), c = h[3] / (2 * tiny);
        Real b = k[2] / (2 * tiny), d = k[3] / (2 * tiny);
        Real determinant = a * d - b * c;
        x[0] -= (d * f[2] - b * f[3]) / determinant;
        x[1] -= (a * f[3] - c * f[2]) / determinant;
    }
    return x;
}

// How long from t until the guard is zero, within h, where it has the other sign.
Real close_in(const ModelB& m, bool coupled, int which, Real t, const State& x, Real h) {
    Real lo = 0, hi = h, at_lo = m.guard(coupled, which, x);
    Real at_hi = m.guard(coupled, which, step(m, coupled, t, x, h));
    int side = 0;
    for (int round = 0; round < 200 && hi - lo > 1e-31Q; round++) {
        Real at = (lo * at_hi - hi * at_lo) / (at_hi - at_lo);
        if (round % 4 == 3 || at_lo <= 0) at = (lo + hi) / 2;
        Real value = m.guard(coupled, which, step(m, coupled, t, x, at));
        if (value == 0) return at;
        if (value > 0) {
            lo = at, at_lo = value;
            if (side == 1) at_hi /= 2;
            side = 1;
        } else {
            hi = at, at_hi = value;
            if (side == -1) at_lo /= 2;
            side = -1;
        }
    }
    return hi;
}

void print(Real t, const char* guard, bool from, bool to) {
    char text[64];
    quadmath_snprintf(text, sizeof text, "%.24Qg", t);
    printf("%s %s B%d B%d\n", text, guard, from ? 1 : 2, to ? 1 : 2);
    fflush(stdout);
}

int main(int count, char** words) {
    Real factor = number(words[1]), t_end = number(words[2]);
    int most = count > 3 ? atoi(words[3]) : 0, events = 0;
    ModelB m(factor);
    // The fastest oscillation, of key and hammer on k2, with k1.
    Real reach = m.L1 - m.L3;
    Real stiffness = m.k1 / m.JK + m.k2 * (m.L1 * m.L1 / m.JK + reach * reach / m.JH);
    Real longest = RADIANS / sqrtq(stiffness);
    State x = equilibrium(m);
    bool coupled = true;
    Real t = 0;
    while (t < t_end && (most == 0 || events < most)) {
        Real h = fminq(longest, t_end - t);
        State end = step(m, coupled, t, x, h);
        int first = -1;
        Real when = h;
        for (int which = 0; which < 2; which++) {
            // A guard that begins at zero does not count until it has been positive.
            if (m.guard(coupled, which, x) < ZERO_BAND) continue;
            if (m.guard(coupled, which, end) > 0) continue;
            Real at = close_in(m, coupled, which, t, x, h);
            if (at < when) first = which, when = at;
        }
        if (first < 0) {
            t += h, x = end;
            continue;
        }
        x = step(m, coupled, t, x, when);
        t += when;
        events++;
        if (first == 1) {
            print(t, "string", coupled, coupled);
            x[0] = m.string_angle;
            x[2] = -x[2];
        } else {
            print(t, coupled ? "release" : "land", coupled, !coupled);
            coupled = !coupled;
        }
    }
}
