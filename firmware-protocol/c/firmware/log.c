#include "log.h"

static void set_text(struct letoff_log_line *line, const char *text)
{
    memset(line->text, 0, sizeof line->text);
    for (size_t i = 0; i < sizeof line->text && text[i] != 0; i++) {
        line->text[i] = (uint8_t)text[i];
    }
}

void log_write(struct log *log, uint32_t now_us, const char *text)
{
    if (log->lines == UINT16_MAX) {
        return;
    }
    struct letoff_log_line *line = &log->kept[log->lines % LOG_LINES];
    line->board_us = now_us;
    set_text(line, text);
    log->lines++;
}

bool log_read(const struct log *log, uint16_t number, struct letoff_log_line *line)
{
    if (log->lines <= number) {
        return false;
    }
    *line = log->kept[number % LOG_LINES];
    if (number + LOG_LINES < log->lines) {
        line->board_us = 0;
        set_text(line, "(no longer kept)");
    }
    line->lines = log->lines;
    return true;
}
