// Writes a reference trajectory: reference NAME T_END TOLERANCE "A,tc,w;A,tc,w;..." name=value ...
// The input is s(t) = sum A (1 + tanh((t - tc)/w))/2. Start: equilibrium at s = 0, frictions unwound.
#include "solver.hh"
#include <sstream>

static const char* const COLUMNS[NS] = {"theta_k", "theta_w", "theta_j", "theta_l", "theta_h", "w_k", "theta_w'", "theta_j'", "theta_l'", "w_h", "z_k", "z_c", "z_h"};
// From absolute angles to those of the description.
static Vec described(const Vec& y) {
    Vec d = y;
    for (int o = 0; o < 10; o += 5) { d[o + 1] = -y[o + 1]; d[o + 2] = y[o + 2] - y[o + 1]; d[o + 3] = y[o + 3] - y[o + 1]; }
    return d;
}
int main(int argc, char** argv) {
    std::string name = argv[1]; double t_end = atof(argv[2]), tol = atof(argv[3]);
    std::vector<std::array<double, 3>> bells;
    { std::stringstream ss(argv[4]); std::string part; while (std::getline(ss, part, ';')) { std::array<double, 3> b; sscanf(part.c_str(), "%lf,%lf,%lf", &b[0], &b[1], &b[2]); bells.push_back(b); } }
    Params P; auto names = P.names();
    for (int i = 5; i < argc; i++) { char* eq = strchr(argv[i], '='); std::string n(argv[i], eq); if (!names.count(n)) return 2; *names[n] = atof(eq + 1); }
    Model m{P};
    auto s = [&](double t) { Input in{0, 0}; for (auto& b : bells) { double th = std::tanh((t - b[1]) / b[2]); in.s += b[0] * (1 + th) / 2; in.v += b[0] / (2 * b[2]) * (1 - th * th); } return in; };
    Solver q(m, s);
    q.rtol = tol; q.atol = tol * 1e-2; q.hmax = 5e-4; q.locate = (1u << NC) - 1; q.exact = true;
    Vec y0 = rest(P); q.start(y0);
    FILE* csv = fopen((name + ".csv").c_str(), "w");
    fprintf(csv, "t"); for (auto c : COLUMNS) fprintf(csv, ",%s", c); fprintf(csv, ",s,F_KU\n");
    auto row = [&]() {
        Vec d = described(q.y); Model::Eval e; Input in = s(q.t); m.eval(q.y.data(), in, q.mask(), e);
        fprintf(csv, "%.3f", q.t); for (double x : d) fprintf(csv, ",%.16e", x); fprintf(csv, ",%.16e,%.16e\n", in.s, e.F);
    };
    row();
    int n = int(std::round(t_end / 0.005));
    for (int i = 1; i <= n; i++) { q.run(i * 0.005); q.t = i * 0.005; row(); }
    fclose(csv);
    FILE* f = fopen((name + ".events").c_str(), "w");
    for (auto& e : q.events) { Vec d = described(e.y); fprintf(f, "%.16e %s", e.t, e.name.c_str()); for (double x : d) fprintf(f, " %.16e", x); fprintf(f, "\n"); }
    fclose(f);
    Vec d = described(y0); for (double x : d) printf("%.17g ", x);
    printf("\n%ld evaluations\n", q.evals);
}
