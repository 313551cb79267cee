#include "report.h"

#include "../firmware/board.h"
#include "faults.h"
#include "finger.h"
#include "motor.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* One step [s]. */
#define H (1e-6 * STEP_US)
/* Steps in a millisecond. */
#define STEPS_PER_MS (1000 / STEP_US)
/* Speed from which on a force counts as along the motion [m/s]. */
#define MOVES 2e-3
/* Force from which on a motor counts as pushing [N]. */
#define PUSHES 0.5

struct key_account {
    /* Work of the motor on the key, and its lowest value so far [J]. */
    double work;
    double lowest_work;
    double handed_out;
    double largest_force;
    double largest_along;
    double largest_step;
    double heat;
    double force_after_fault;
    /* Age of the fault [s] when the motor pushed last; negative if it never did. */
    double last_force;
    double highest;
    double deepest;
    /* Commands of the last millisecond. */
    double commands[STEPS_PER_MS];
    uint64_t steps;
};

static struct key_account keys[N_KEYS];

static double larger(double a, double b)
{
    return a < b ? b : a;
}

static void account_command(struct key_account *key, double command)
{
    for (size_t i = 0; i < STEPS_PER_MS; i++) {
        key->largest_step = larger(key->largest_step, fabs(command - key->commands[i]));
    }
    key->commands[key->steps++ % STEPS_PER_MS] = command;
}

static void account_fault(struct key_account *key, const struct account_step *step)
{
    if (faults_began() && PUSHES < fabs(step->force)) {
        key->force_after_fault += H;
        key->last_force = faults_age(step->now_us);
    }
}

void account(size_t slot, const struct account_step *step)
{
    struct key_account *key = &keys[slot];
    if (key->steps == 0) {
        key->last_force = -1.0;
    }
    account_command(key, step->command);
    account_fault(key, step);
    key->work -= step->force * (step->to - step->from);
    key->lowest_work = key->work < key->lowest_work ? key->work : key->lowest_work;
    key->handed_out = larger(key->handed_out, key->work - key->lowest_work);
    key->largest_force = larger(key->largest_force, fabs(step->force));
    if (MOVES < fabs(step->velocity) && step->force * step->velocity < 0.0) {
        key->largest_along = larger(key->largest_along, fabs(step->force));
    }
    key->heat += H * step->force * step->force;
    key->deepest = larger(key->deepest, step->to);
    key->highest = step->to < key->highest ? step->to : key->highest;
}

/* ---- Writing. ---- */

static void write_key(FILE *file, size_t slot)
{
    const struct key_account *key = &keys[slot];
    fprintf(file, "    {\"slot\": %zu, \"handed_out_mj\": %.6f, \"work_mj\": %.6f,\n", slot,
            1e3 * key->handed_out, 1e3 * key->work);
    fprintf(file, "     \"largest_force_n\": %.6f, \"largest_along_n\": %.6f,\n",
            key->largest_force, key->largest_along);
    fprintf(file, "     \"largest_step_n\": %.6f, \"heat\": %.6f, \"temperature_c\": %.3f,\n",
            key->largest_step, key->heat, motor_temperature(slot));
    fprintf(file, "     \"force_after_fault_s\": %.4f, ", key->force_after_fault);
    if (key->steps == 0 || key->last_force < 0.0) {
        fprintf(file, "\"last_force_s\": null,\n");
    } else {
        fprintf(file, "\"last_force_s\": %.4f,\n", key->last_force);
    }
    fprintf(file, "     \"positions_mm\": [%.4f, %.4f]}%s\n", 1e3 * key->highest,
            1e3 * key->deepest, slot + 1 < N_KEYS ? "," : "");
}

static void write_faults(FILE *file)
{
    const char *between = "";
    fprintf(file, "  \"faults\": [");
    for (int fault = 0; fault < FAULT_COUNT; fault++) {
        const char *name = faults_name((enum fault)fault);
        if (name != NULL) {
            fprintf(file, "%s\"%s\"", between, name);
            between = ", ";
        }
    }
    fprintf(file, "],\n");
}

static void write_board(FILE *file, const struct board_account *board)
{
    write_faults(file);
    fprintf(file, "  \"finger\": \"%s\", \"seed\": %llu,\n", finger_script(),
            (unsigned long long)board->seed);
    if (board->was_armed) {
        fprintf(file, "  \"since_first_arm_s\": %.4f,", board->since_arm_s);
    } else {
        fprintf(file, "  \"since_first_arm_s\": null,");
    }
    fprintf(file, " \"armings\": %u, \"restarts\": %u,\n", (unsigned)board->armings,
            (unsigned)board->restarts);
    fprintf(file, "  \"forces\": %u, \"refused\": %u, \"stale\": %u, \"samples\": %u,\n",
            (unsigned)board->forces, (unsigned)board->refused, (unsigned)board->stale,
            (unsigned)board->samples);
    fprintf(file, "  \"unsent\": %u, \"trips\": %u, \"muted\": %u,\n", (unsigned)board->unsent,
            (unsigned)board->trips, (unsigned)board->muted);
}

bool report_write(const char *path, const struct board_account *board)
{
    char draft[4096];
    int len = snprintf(draft, sizeof draft, "%s.part", path);
    FILE *file = 0 < len && (size_t)len < sizeof draft ? fopen(draft, "w") : NULL;
    if (file == NULL) {
        fprintf(stderr, "rig: cannot write the report %s\n", path);
        return false;
    }
    fprintf(file, "{\n");
    write_board(file, board);
    fprintf(file, "  \"keys\": [\n");
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        write_key(file, slot);
    }
    fprintf(file, "  ]\n}\n");
    bool written = ferror(file) == 0;
    written = fclose(file) == 0 && written && rename(draft, path) == 0;
    if (!written) {
        fprintf(stderr, "rig: cannot write the report %s\n", path);
    }
    return written;
}
