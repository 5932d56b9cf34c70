FROM debian:12-slim
COPY jounce_*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends git /tmp/jounce_*.deb && rm -rf /var/lib/apt/lists/* /tmp/*.deb
