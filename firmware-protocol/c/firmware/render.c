#include "render.h"

static float force_of(const struct state *state, size_t slot, uint32_t at_us, int32_t share)
{
    const struct plant_key *key = &state->keys[slot];
    if ((state->muted >> slot & 1u) != 0) {
        return 0.0f;
    }
    float limit = 1e-3f * (float)state->settings[LETOFF_SETTING_MAX_FORCE_MN];
    return law_force(&state->forces.keys[slot], at_us, plant_counts(key), plant_velocity(key),
                     share, limit);
}

/* The steps of one key. One that is at rest and that nothing touches has none to make. */
static void render_key(struct state *state, size_t slot, uint32_t steps)
{
    struct plant_key *key = &state->keys[slot];
    uint32_t at_us = state->law_us;
    uint32_t until_us = at_us + steps * STEP_US;
    int32_t share = arm_share(&state->arm, at_us);
    if (share == arm_share(&state->arm, until_us) &&
        plant_is_still(key, force_of(state, slot, at_us, share), until_us)) {
        return;
    }
    for (uint32_t step = 0; step < steps; step++, at_us += STEP_US) {
        plant_step(key, force_of(state, slot, at_us, arm_share(&state->arm, at_us)), at_us);
    }
}

void render(struct state *state, uint32_t now_us)
{
    uint32_t steps = (now_us - state->law_us) / STEP_US;
    if (MOST_STEPS < steps) {
        log_write(&state->log, now_us, "too late: time left out");
        state->law_us += (steps - MOST_STEPS) * STEP_US;
        steps = MOST_STEPS;
    }
    if (steps == 0) {
        return;
    }
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        render_key(state, slot, steps);
    }
    state->law_us += steps * STEP_US;
}
