/* SUNDIALS CVODE with its root finding, restarted with CVodeReInit at each event.
 *
 * default: BDF with Newton and a dense matrix, tolerances of the manual's first example
 * (cvRoberts_dns: 1e-4 and 1e-8), nothing else set.
 * best, as the manual advises: Adams with the fixed-point iteration for what is not stiff,
 * BDF beside it; CVodeSetRootDirection, CVodeSetStopTime, CVodeSetMaxStep so that the stroke
 * is not jumped over, CVodeReInit at discontinuities and instead of a new solver per run.
 *
 * Prints one line of JSON per row. */
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <time.h>

#include "problems.h"

enum { MOST_EVENTS = 100, MOST_TIMES = 2000 };

/* What a run leaves behind. */
typedef struct {
    int events, states_taken, is_sampling;
    double t[MOST_EVENTS];
    const char *guard[MOST_EVENTS];
    double states[4 * MOST_SAMPLES];
    long evaluations;
    const char *error;
} Log;

typedef struct {
    void *memory;
    N_Vector x;
    SUNMatrix matrix;
    SUNLinearSolver linear;
    SUNNonlinearSolver fixed_point;
} Solver;

static int rhs(double t, N_Vector x, N_Vector dx, void *problem) {
    derivative(problem, t, N_VGetArrayPointer(x), N_VGetArrayPointer(dx));
    return 0;
}

static int root(double t, N_Vector x, double *g, void *problem) {
    (void)t;
    guard_values(problem, N_VGetArrayPointer(x), g);
    return 0;
}

static Solver make(Problem *p, int method, int is_best, double rtol, double atol, SUNContext sun) {
    Solver s = {CVodeCreate(method, sun), N_VNew_Serial(states(p), sun), 0, 0, 0};
    int falling[2] = {-1, -1};
    start(p, N_VGetArrayPointer(s.x));
    CVodeInit(s.memory, rhs, 0, s.x);
    CVodeSStolerances(s.memory, rtol, atol);
    CVodeSetUserData(s.memory, p);
    CVodeRootInit(s.memory, guards(p), root);
    CVodeSetMaxNumSteps(s.memory, 1000000);
    CVodeSetErrFile(s.memory, NULL);
    if (method == CV_ADAMS) {
        s.fixed_point = SUNNonlinSol_FixedPoint(s.x, 0, sun);
        CVodeSetNonlinearSolver(s.memory, s.fixed_point);
    } else {
        s.matrix = SUNDenseMatrix(states(p), states(p), sun);
        s.linear = SUNLinSol_Dense(s.x, s.matrix, sun);
        CVodeSetLinearSolver(s.memory, s.linear, s.matrix);
    }
    if (is_best) {
        CVodeSetRootDirection(s.memory, falling);
        CVodeSetMaxStep(s.memory, longest_step(p));
    }
    return s;
}

static void release(Solver *s) {
    CVodeFree(&s->memory);
    if (s->fixed_point) SUNNonlinSolFree(s->fixed_point);
    if (s->linear) SUNLinSolFree(s->linear);
    if (s->matrix) SUNMatDestroy(s->matrix);
    N_VDestroy(s->x);
}

/* Takes the wanted states that CVODE has stepped over. */
static void sample(Solver *s, const Problem *p, double until, N_Vector at, Log *log) {
    while (log->states_taken < p->samples && p->sample[log->states_taken] <= until * (1 + 1e-14)) {
        CVodeGetDky(s->memory, fmin(p->sample[log->states_taken], until), 0, at);
        memcpy(log->states + states(p) * log->states_taken++, N_VGetArrayPointer(at),
               states(p) * sizeof(double));
    }
}

/* Writes an event down and goes on behind it; false if that is one too many. */
static int leave(Solver *s, Problem *p, double t, int is_best, Log *log) {
    int found[2] = {0, 0};
    double *x = N_VGetArrayPointer(s->x);
    CVodeGetRootInfo(s->memory, found);
    for (int i = 0; i < guards(p); i++) {
        if (found[i] >= 0) continue;
        if (log->events == MOST_EVENTS) { log->error = "too many events"; return 0; }
        log->t[log->events] = t;
        log->guard[log->events++] = guard_name(p, i);
        fire(p, i, x);
        CVodeReInit(s->memory, t, s->x);
        if (is_best) CVodeSetStopTime(s->memory, p->t_end);
        break;
    }
    return 1;
}

/* One run from the start to the end. */
static void run(Solver *s, Problem *p, int is_best, N_Vector spare, Log *log) {
    long count = 0;
    double t = 0;
    log->events = log->states_taken = 0;
    log->evaluations = 0;
    log->error = NULL;
    start(p, N_VGetArrayPointer(s->x));
    CVodeReInit(s->memory, 0, s->x);
    if (is_best) CVodeSetStopTime(s->memory, p->t_end);
    while (t < p->t_end) {
        int task = log->is_sampling ? CV_ONE_STEP : CV_NORMAL;
        int flag = CVode(s->memory, p->t_end, s->x, &t, task);
        if (flag < 0) { log->error = CVodeGetReturnFlagName(flag); return; }
        if (log->is_sampling) sample(s, p, fmin(t, p->t_end), spare, log);
        CVodeGetNumRhsEvals(s->memory, &count);
        if (flag == CV_ROOT_RETURN && t < p->t_end) {
            int before = log->events;
            if (!leave(s, p, t, is_best, log)) return;
            if (log->events > before) log->evaluations += count, count = 0;
        } else if (task == CV_NORMAL) break;
    }
    log->evaluations += count;
}

static double now(void) {
    struct timespec time;
    /* Of this thread: see src/measure.rs. */
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

/* Times runs for about the budget; returns how many times there are. */
static int time_runs(Solver *s, Problem *p, int is_best, N_Vector spare, double *times) {
    static Log log;
    int n = 0;
    double begin = now();
    log.is_sampling = 0;
    do {
        double before = now();
        int batch = 0;
        do { run(s, p, is_best, spare, &log); batch++; } while (now() - before < 100e3);
        times[n++] = (now() - before) / batch;
    } while (n < MOST_TIMES && (n < 3 || now() - begin < 1e6 * p->budget_ms)
             && !(times[0] > 300e6));
    return n;
}

static void print(const char *method, const char *setting, double knob, const Log *log,
                  const Problem *p, const double *times, int n) {
    printf("{\"version\":\"%s\",\"method\":\"%s\",\"setting\":\"%s\",\"knob\":%.17g,", SUNDIALS_VERSION,
           method, setting, knob);
    printf("\"note\":\"CVodeRootInit; CVodeReInit at events%s\",\"events\":[",
           strcmp(setting, "default") ? "; root direction, stop time and longest step set" : "");
    for (int i = 0; i < log->events; i++)
        printf("%s[%.17g,\"%s\"]", i ? "," : "", log->t[i], log->guard[i]);
    printf("],\"states\":[");
    for (int i = 0; i < states(p) * log->states_taken; i++)
        printf("%s%.17g", i ? "," : "", log->states[i]);
    printf("],\"rhs\":%ld,\"ns\":[", log->evaluations);
    for (int i = 0; i < n; i++) printf("%s%.1f", i ? "," : "", times[i]);
    printf("],\"error\":");
    if (log->error) printf("\"%s\"}\n", log->error);
    else printf("null}\n");
}

static void row(Problem *p, int method, const char *setting, double rtol, double atol,
                SUNContext sun) {
    static Log log;
    static double times[MOST_TIMES];
    int is_best = strcmp(setting, "default") != 0, n = 0;
    Solver s = make(p, method, is_best, rtol, atol, sun);
    N_Vector spare = N_VClone(s.x);
    log.is_sampling = 1;
    run(&s, p, is_best, spare, &log);
    /* Counted as it is timed: without samples. */
    Log sampled = log;
    log.is_sampling = 0;
    run(&s, p, is_best, spare, &log);
    sampled.evaluations = log.evaluations;
    if (!log.error) n = time_runs(&s, p, is_best, spare, times);
    print(method == CV_ADAMS ? "Adams" : "BDF", setting, rtol, &sampled, p, times, n);
    N_VDestroy(spare);
    release(&s);
}

int main(int count, char **words) {
    static Problem problem;
    SUNContext sun;
    if (count != 2 || read_problem(words[1], &problem)) {
        fprintf(stderr, "cvode: a parameter file is needed\n");
        return 1;
    }
    if (SUNContext_Create(NULL, &sun)) return 1;
    row(&problem, CV_BDF, "default", 1e-4, 1e-8, sun);
    for (int i = 0; i < problem.tolerances; i++) {
        double tolerance = problem.tolerance[i];
        row(&problem, CV_ADAMS, "sweep", tolerance, tolerance, sun);
        row(&problem, CV_BDF, "sweep", tolerance, tolerance, sun);
    }
    SUNContext_Free(&sun);
    return 0;
}
