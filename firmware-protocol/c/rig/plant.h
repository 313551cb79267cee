/* A key with finger, motor and encoder, for one step. */
#ifndef RIG_PLANT_H
#define RIG_PLANT_H

#include "../firmware/plant.h"

struct plant_step {
    size_t slot;
    /* Force that the law wants [N], positive upwards. */
    float command;
    /* The board's clock, the host's time, and the time since power on [us]. */
    uint32_t clock_us;
    uint64_t now_us;
    uint64_t age_us;
    /* `false` while the board is dark. */
    bool powered;
};

void plant_move(struct plant_key *key, const struct plant_step *step);

#endif
