/* The problems, as in src/problems: equations, guards, reset maps. */
#ifndef PROBLEMS_H
#define PROBLEMS_H

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_SAMPLES = 1000, MOST_TOLERANCES = 64 };

/* Everything that the parameter file says; SI units. */
typedef struct {
    int is_ball;
    double t_end, budget_ms;
    double g, e, height;                                  /* ball */
    double l[4], weight_key, weight_hammer, k1, k2;       /* model B */
    double jk, jh, string, restitution, bell[9], rest[4];
    double tolerance[MOST_TOLERANCES], sample[MOST_SAMPLES];
    int tolerances, samples;
    int is_coupled;                                       /* the mode */
} Problem;

static int states(const Problem *p) { return p->is_ball ? 2 : 4; }
static int guards(const Problem *p) { return p->is_ball ? 1 : 2; }

/* The longest step [s] with which no bell is jumped over; 0 for none. */
static double longest_step(const Problem *p) {
    double most = 0;
    for (int i = 0; i < 9 && !p->is_ball; i += 3) most = fmax(most, p->bell[i + 2]);
    return most > 0 ? 1 / most : 0;
}

static void start(Problem *p, double *x) {
    p->is_coupled = 1;
    if (p->is_ball) { x[0] = p->height; x[1] = 0; }
    else memcpy(x, p->rest, sizeof p->rest);
}

static double gap(const Problem *p, const double *x) {
    return p->l[3] * cos(x[0]) - p->l[2] * sin(x[0]) - p->l[0] * sin(x[1] - x[0]);
}

static void derivative(const Problem *p, double t, const double *x, double *dx) {
    if (p->is_ball) { dx[0] = x[1]; dx[1] = -p->g; return; }
    double s = 0;
    for (int i = 0; i < 9; i += 3) {
        double z = (t - p->bell[i + 1]) * p->bell[i + 2];
        s += p->bell[i] * exp(-z * z);
    }
    double hammer = 0, key = 0, cos_h = cos(x[0]), cos_k = cos(x[1]);
    if (p->is_coupled) {
        double sin_h = sin(x[0]), sin_k = sin(x[1]);
        double sin_d = sin_k * cos_h - cos_k * sin_h;
        double secant = 1 / (cos_k * cos_h + sin_k * sin_h);
        double q4 = (p->l[0] * sin_d - p->l[3] * cos_h + p->l[2] * sin_h) * secant;
        double q3 = (p->l[0] - p->l[2] * cos_k - p->l[3] * sin_k) * secant;
        double force = p->k2 * q4;
        hammer = force * q3 * secant;
        key = -force * (p->l[0] + q4 * sin_d * secant);
    }
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = (hammer - p->weight_hammer * cos_h) / p->jh;
    dx[3] = (p->k1 * (s - x[1]) + key - p->weight_key * cos_k) / p->jk;
}

/* Positive while the mode is valid. */
static void guard_values(const Problem *p, const double *x, double *g) {
    if (p->is_ball) { g[0] = x[0]; return; }
    g[0] = p->is_coupled ? -gap(p, x) : gap(p, x);
    g[1] = p->string - x[0];
}

static const char *guard_name(const Problem *p, int guard) {
    if (p->is_ball) return "floor";
    if (guard == 1) return "string";
    return p->is_coupled ? "release" : "land";
}

static void fire(Problem *p, int guard, double *x) {
    if (p->is_ball) { x[0] = 0; x[1] *= -p->e; }
    else if (guard == 0) p->is_coupled = !p->is_coupled;
    else { x[0] = p->string; x[2] *= -p->restitution; }
}

/* Where the value called `name` goes; NULL if it is not known. */
static double *slot(Problem *p, const char *name) {
    struct { const char *name; double *slot; } known[] = {
        {"t_end", &p->t_end}, {"budget_ms", &p->budget_ms}, {"g", &p->g}, {"e", &p->e},
        {"height", &p->height}, {"L1", &p->l[0]}, {"L2", &p->l[1]}, {"L3", &p->l[2]},
        {"L4", &p->l[3]}, {"weight_key", &p->weight_key}, {"weight_hammer", &p->weight_hammer},
        {"k1", &p->k1}, {"k2", &p->k2}, {"JK", &p->jk}, {"JH", &p->jh}, {"string", &p->string},
        {"restitution", &p->restitution},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (!strcmp(known[i].name, name)) return known[i].slot;
    int index;
    if (sscanf(name, "bell%d", &index) == 1 && index < 9) return &p->bell[index];
    if (sscanf(name, "rest%d", &index) == 1 && index < 4) return &p->rest[index];
    if (!strcmp(name, "tolerance") && p->tolerances < MOST_TOLERANCES)
        return &p->tolerance[p->tolerances++];
    if (!strcmp(name, "sample") && p->samples < MOST_SAMPLES) return &p->sample[p->samples++];
    return NULL;
}

/* Reads the parameter file; 0 if all is well. */
static int read_problem(const char *path, Problem *p) {
    char name[64], text[64];
    FILE *file = fopen(path, "r");
    if (!file) return 1;
    memset(p, 0, sizeof *p);
    while (fscanf(file, "%63s %63s", name, text) == 2) {
        double *value;
        if (!strcmp(name, "problem")) { p->is_ball = !strcmp(text, "ball"); continue; }
        value = slot(p, name);
        if (!value || sscanf(text, "%lf", value) != 1) { fclose(file); return 1; }
    }
    fclose(file);
    return 0;
}

#endif
