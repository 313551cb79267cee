#include "plant.h"

#include "../firmware/lever.h"
#include "encoder.h"
#include "finger.h"
#include "motor.h"
#include "report.h"

/* The scripted finger, at the place of the key that it plays. */
static struct plant_key scripted;

/* Moves the scripted finger for one step; returns its push on the key [N]. */
static float scripted_push(const struct plant_key *key, uint64_t age_us)
{
    struct command command;
    bool lands;
    scripted.position = key->position;
    scripted.velocity = key->velocity;
    if (!finger_command(age_us, &command, &lands)) {
        lever_leave(&scripted);
        return 0.0f;
    }
    if (lands) {
        scripted.tip = command.position;
        scripted.tip_velocity = command.velocity;
    }
    return lever_touch(&scripted, command);
}

void plant_move(struct plant_key *key, const struct plant_step *step)
{
    double from = (double)key->position;
    float push = lever_play(key, step->clock_us);
    if (step->slot == 0) {
        push += scripted_push(key, step->age_us);
    }
    double force = motor_step(step->slot, (double)step->command, from, (double)key->velocity,
                              step->powered);
    key->motor = (float)force;
    lever_step(key, key->motor - push);
    double velocity = (double)key->velocity;
    encoder_read(step->slot, (double)key->position, velocity);
    struct account_step done = {
        .command = (double)step->command,
        .force = force,
        .from = from,
        .to = (double)key->position,
        .velocity = velocity,
        .now_us = step->now_us,
    };
    account(step->slot, &done);
}
