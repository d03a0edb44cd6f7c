# Roomatlas in a container, in two stages: packages are built in the first, the second has these and what they
# depend on.
#
#     docker build -t roomatlas .
#     docker run --rm -u "$(id -u):$(id -g)" -v "$PWD:/data" roomatlas build my_bag -o OUT
FROM debian:12 AS build
WORKDIR /roomatlas
COPY . .
RUN ./run package build

FROM debian:12-slim
COPY --from=build /roomatlas/out/packages /packages
# With the plug-ins; without them leave out roomatlas-gdal and roomatlas-pictures.
RUN apt-get update \
 && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
      /packages/roomatlas_*.deb /packages/roomatlas-pictures_*.deb /packages/roomatlas-gdal_*.deb \
      /packages/python3-roomatlas_*.deb python3-shapely python3-networkx \
 && rm -rf /var/lib/apt/lists/* /packages
WORKDIR /data
ENTRYPOINT ["roomatlas"]
CMD ["--help"]
