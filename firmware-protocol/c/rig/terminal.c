/* Real time, behind a pseudo-terminal. */
#define _XOPEN_SOURCE 700

#include "machine.h"
#include "session.h"
#include "wire.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

/* Longest sleep [us]: a fault may begin at any time. Shortest one: a frame that is due and that
 * the terminal does not take is tried again after it. */
#define LONGEST_SLEEP_US 1000u
#define SHORTEST_SLEEP_US 100u
#define SECOND_US 1000000u
#define MAX_PATH_LEN 4096

struct terminal {
    int master;
    /* Open as long as the rig runs, so that hosts may come and go. */
    int slave;
    char path[MAX_PATH_LEN];
    /* Bytes that the terminal has not taken yet. */
    struct packet rest;
};

static volatile sig_atomic_t stopped;

static void stop(int signal)
{
    (void)signal;
    stopped = 1;
}

/* Blocks the signals that end the rig; `open` becomes the mask without them, for sleeps. */
static void catch_signals(sigset_t *open)
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = stop;
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGINT, &action, NULL);
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigaddset(&blocked, SIGINT);
    sigprocmask(SIG_BLOCK, &blocked, open);
    sigdelset(open, SIGTERM);
    sigdelset(open, SIGINT);
}

/* Bytes pass as they are. */
static bool make_raw(int file)
{
    struct termios modes;
    if (tcgetattr(file, &modes) != 0) {
        return false;
    }
    modes.c_iflag &= ~(tcflag_t)(IGNBRK | BRKINT | PARMRK | ISTRIP | INLCR | IGNCR | ICRNL | IXON);
    modes.c_oflag &= ~(tcflag_t)OPOST;
    modes.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | ISIG | IEXTEN);
    modes.c_cflag &= ~(tcflag_t)(CSIZE | PARENB);
    modes.c_cflag |= CS8;
    modes.c_cc[VMIN] = 1;
    modes.c_cc[VTIME] = 0;
    return tcsetattr(file, TCSANOW, &modes) == 0;
}

static bool open_terminal(struct terminal *terminal)
{
    terminal->master = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal->master < 0 || grantpt(terminal->master) != 0 ||
        unlockpt(terminal->master) != 0) {
        return false;
    }
    const char *path = ptsname(terminal->master);
    if (path == NULL || sizeof terminal->path <= strlen(path)) {
        return false;
    }
    strcpy(terminal->path, path);
    terminal->slave = open(path, O_RDWR | O_NOCTTY);
    int flags = fcntl(terminal->master, F_GETFL);
    return 0 <= terminal->slave && make_raw(terminal->slave) && 0 <= flags &&
           fcntl(terminal->master, F_SETFL, flags | O_NONBLOCK) == 0;
}

/* Makes `path` a link to the terminal, in place of an older link. */
static bool make_link(const struct terminal *terminal, const char *path)
{
    char draft[MAX_PATH_LEN];
    int len = snprintf(draft, sizeof draft, "%s.%ld", path, (long)getpid());
    return 0 < len && (size_t)len < sizeof draft && symlink(terminal->path, draft) == 0 &&
           rename(draft, path) == 0;
}

/* Removes the link unless another rig has replaced it. */
static void remove_link(const struct terminal *terminal, const char *path)
{
    char target[MAX_PATH_LEN];
    ssize_t len = readlink(path, target, sizeof target - 1);
    if (0 < len) {
        target[len] = 0;
        if (strcmp(target, terminal->path) == 0) {
            (void)unlink(path);
        }
    }
}

static uint64_t clock_now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * SECOND_US + (uint64_t)now.tv_nsec / 1000u;
}

/* Writes the rest; returns `false` if the terminal did not take all of it. */
static bool write_rest(struct terminal *terminal)
{
    struct packet *rest = &terminal->rest;
    if (rest->len == 0) {
        return true;
    }
    ssize_t written = write(terminal->master, rest->bytes, rest->len);
    if (0 < written) {
        rest->len -= (size_t)written;
        memmove(rest->bytes, rest->bytes + written, rest->len);
    }
    return rest->len == 0;
}

static void send_due(struct terminal *terminal)
{
    bool room = write_rest(terminal);
    while (room) {
        const struct packet *packet = wire_to_host(PACKET_ROOM);
        if (packet == NULL) {
            break;
        }
        terminal->rest = *packet;
        room = write_rest(terminal);
    }
    wire_block(!room);
}

static void receive(const struct terminal *terminal)
{
    uint8_t bytes[1024];
    ssize_t n = read(terminal->master, bytes, sizeof bytes);
    if (0 < n) {
        machine_receive(bytes, (size_t)n);
    }
}

/* Sleeps until bytes come, the board has something to send, or a signal arrives. `run_us` is the
 * time up to which the board has run. */
static void sleep_until_due(const struct terminal *terminal, uint64_t run_us, const sigset_t *open)
{
    uint64_t idle_us = wire_idle(machine_idle(LONGEST_SLEEP_US));
    uint64_t due_us = run_us + (idle_us < SHORTEST_SLEEP_US ? SHORTEST_SLEEP_US : idle_us);
    uint64_t now_us = clock_now_us();
    struct timespec timeout = {0, due_us < now_us ? 0 : (long)(1000u * (due_us - now_us))};
    fd_set readable;
    FD_ZERO(&readable);
    FD_SET(terminal->master, &readable);
    (void)pselect(terminal->master + 1, &readable, NULL, NULL, &timeout, open);
}

static int run(struct terminal *terminal, const struct settings *settings)
{
    sigset_t open;
    catch_signals(&open);
    printf("%s\n", terminal->path);
    fflush(stdout);
    session_begin(settings, clock_now_us());
    while (!stopped) {
        uint64_t now_us = clock_now_us();
        machine_run(now_us, false);
        receive(terminal);
        send_due(terminal);
        session_report_each_second(settings, now_us);
        sleep_until_due(terminal, now_us, &open);
    }
    return session_report(settings) ? 0 : 1;
}

int run_terminal(const struct settings *settings)
{
    static struct terminal terminal;
    if (!open_terminal(&terminal)) {
        fprintf(stderr, "rig: no pseudo-terminal: %s\n", strerror(errno));
        return 1;
    }
    if (settings->link != NULL && !make_link(&terminal, settings->link)) {
        fprintf(stderr, "rig: cannot make the link %s: %s\n", settings->link, strerror(errno));
        return 1;
    }
    int code = run(&terminal, settings);
    if (settings->link != NULL) {
        remove_link(&terminal, settings->link);
    }
    return code;
}
