# Install rules shared by all layers are in layer.cmake; here the package files are written.
