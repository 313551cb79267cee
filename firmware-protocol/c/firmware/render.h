/* Law and plant, step by step, up to the present. */
#ifndef RENDER_H
#define RENDER_H

#include "state.h"

/* Makes all steps that have become due by `now_us`. */
void render(struct state *state, uint32_t now_us);

#endif
