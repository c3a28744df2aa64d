# Prints one value of a JSON file; fails if the file is not JSON or has no such value.
#   cmake -D FILE=x.json -D "KEYS=limit_points;0;step" -P json.cmake
file(READ "${FILE}" text)
string(JSON value GET "${text}" ${KEYS})
execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${value}")
