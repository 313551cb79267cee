#include "law.h"

#include "board.h"

void law_set(struct law_key *key, const struct letoff_forces *forces,
             const struct history_entry *samples, size_t slot)
{
    /* The host says with the flag: render no force. */
    if (forces->header.flag) {
        memset(key, 0, sizeof *key);
        return;
    }
    const float newtons_per_count =
        1e-3f * (float)LETOFF_STIFFNESS_UNIT_MN_M * 1e-9f * (float)QUANTUM_NM;
    const float newton_seconds = 1e-3f * (float)LETOFF_DAMPING_UNIT_MN_S_M;
    key->force = 1e-3f * (float)forces->forces[slot];
    key->stiffness = newtons_per_count * (float)letoff_slope(forces->stiffness[slot]);
    key->damping = newton_seconds * (float)letoff_slope(forces->damping[slot]);
    key->counts = samples->counts[slot];
    key->velocity = samples->velocities[slot];
    key->taken_us = samples->board_us;
    key->counts_per_us = key->velocity * (1e3f / (float)QUANTUM_NM);
}

void law_hold(struct law_key *key, int16_t millinewtons)
{
    memset(key, 0, sizeof *key);
    key->force = 1e-3f * (float)millinewtons;
}

/* How far the key is from where it was expected [counts]. */
static float astray(const struct law_key *key, uint32_t now_us, int32_t counts)
{
    float behind = (float)(key->counts - counts);
    if (key->velocity == 0.0f) {
        return behind;
    }
    uint32_t age_us = now_us - key->taken_us;
    uint32_t along_us = age_us < LETOFF_PATH_US ? age_us : LETOFF_PATH_US;
    return behind + key->counts_per_us * (float)along_us;
}

float law_force(const struct law_key *key, uint32_t now_us, int32_t counts, float velocity,
                int32_t share, float limit)
{
    float force = key->force;
    if (share <= 0) {
        return 0.0f;
    }
    /* Most keys have no slopes or stand still; a multiplication is a hundred instructions here. */
    if (key->stiffness != 0.0f && (key->counts != counts || key->velocity != 0.0f)) {
        force += key->stiffness * astray(key, now_us, counts);
    }
    if (key->damping != 0.0f) {
        force += key->damping * (key->velocity - velocity);
    }
    if (share < 1000) {
        force *= 1e-3f * (float)share;
    }
    if (force < -limit) {
        return -limit;
    }
    return limit < force ? limit : force;
}
