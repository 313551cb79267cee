/* The simulated key with its encoder, its motor, and the finger that plays it.
 *
 * As crates/haptics/src/plant has it, in single precision and with a step of its own. Real
 * hardware has encoders and motors in this place, see README.md.
 */
#ifndef PLANT_H
#define PLANT_H

#include "gesture.h"
#include "law.h"

struct plant_key {
    /* The key's front [m, m/s], down positive, and the motor's force on it [N], up positive. */
    float position;
    float velocity;
    float motor;
    /* The finger, if one plays, and what it plays. */
    bool playing;
    float tip;
    float tip_velocity;
    struct letoff_finger gesture;
    struct stroke stroke;
    struct gestures gestures;
};

/* What the encoder reads. */
int32_t plant_counts(const struct plant_key *key);

/* Velocity that the board measures [m/s], down positive. */
float plant_velocity(const struct plant_key *key);

/* Whether the steps up to `until_us` with the motor's `command` [N] would change nothing. */
bool plant_is_still(const struct plant_key *key, float command, uint32_t until_us);

/* One step of STEP_US from `now_us` on, with `command` [N] for the motor, up positive. */
void plant_step(struct plant_key *key, float command, uint32_t now_us);

#endif
