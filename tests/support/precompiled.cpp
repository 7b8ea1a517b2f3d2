// Only so that the headers of the test libraries are read once (tests/CMakeLists.txt).
