/* Short lines of what happened, the last of them; all zeros is its beginning. */
#ifndef LOG_H
#define LOG_H

#include "../letoff_protocol.h"

#define LOG_LINES 16

struct log {
    uint16_t lines;
    struct letoff_log_line kept[LOG_LINES];
};

void log_write(struct log *log, uint32_t now_us, const char *text);

/* The line `number`; false if it has not been written yet. One that is no longer kept says so. */
bool log_read(const struct log *log, uint16_t number, struct letoff_log_line *line);

#endif
