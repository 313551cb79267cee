mod functions;
mod straight;
