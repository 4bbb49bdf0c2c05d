#!/usr/bin/env Rscript
# Fits a mixed model to trials.csv, which is in the folder of this script or is the first argument.
# Prints how many times as large the error is as in the first condition and session, with 95 %
# intervals (Wald). Then tests the hypotheses of the study, if hypotheses.csv is beside the table:
# Student's t tests of the logarithms of the ratios of participants, Holm's correction over all
# hypotheses, and two one-sided tests against the margin. Requires the package lme4.
# Sources: Holm 1979, https://www.jstor.org/stable/4615733; Schuirmann 1987, DOI 10.1007/BF01068419;
# Lakens 2017, DOI 10.1177/1948550617697177.
suppressPackageStartupMessages(library(lme4))

arguments <- commandArgs()
script <- sub("^--file=", "", grep("^--file=", arguments, value = TRUE))
given <- commandArgs(trailingOnly = TRUE)
file <- if (length(given) > 0) given[1] else file.path(dirname(script[1]), "trials.csv")

all <- read.csv(file, na.strings = "", check.names = FALSE, stringsAsFactors = FALSE)
# The hypotheses count a trial whatever its error is, as the report does.
counted <- all[as.logical(all$valid) & !as.logical(all$is_practice), ]
trials <- counted[!is.na(counted$err_mean_mm) & counted$err_mean_mm > 0, ]
# Returns the levels of a factor in the order of the study, which the data dictionary has: all other
# levels are compared with the first one.
levels_of <- function(column) {
  dictionary <- sub("csv$", "json", file)
  known <- unique(trials[[column]])
  if (!file.exists(dictionary)) return(known)
  line <- grep(paste0("^\"", column, "\":"), readLines(dictionary, encoding = "UTF-8"), value = TRUE)
  text <- sub("}.*", "", sub(".*\"Levels\":\\{", "", line))
  names <- regmatches(text, gregexpr("\"[a-z0-9-]+\":", text))[[1]]
  names <- gsub("[\":]", "", names)
  c(names[names %in% known], setdiff(known, names))
}
trials$condition <- factor(trials$condition, levels = levels_of("condition"))
trials$session <- factor(trials$session, levels = levels_of("session"))
trials$participant <- factor(trials$participant)
trials$shape <- factor(trials$shape)
cat(nrow(trials), "valid trials of", nlevels(trials$participant), "participants\n")

# Returns the logarithm of the ratio of each participant, over the shapes of both conditions.
log_ratios <- function(hypothesis) {
  measure <- hypothesis$measure
  chosen <- counted[counted$session == hypothesis$session & !is.na(counted[[measure]]), ]
  means <- function(name) {
    of <- chosen[chosen$condition == name, ]
    if (nrow(of) == 0) return(data.frame(participant = character(), shape = character(), x = numeric()))
    aggregate(list(x = as.numeric(of[[measure]])), of[c("participant", "shape")], mean)
  }
  both <- merge(means(hypothesis$condition), means(hypothesis$against), by = c("participant", "shape"))
  if (nrow(both) == 0) return(numeric())
  people <- aggregate(both[c("x.x", "x.y")], both["participant"], mean)
  people <- people[people$x.x > 0 & people$x.y > 0, ]
  log(people$x.x / people$x.y)
}
test_hypothesis <- function(hypothesis) {
  logs <- log_ratios(hypothesis)
  row <- data.frame(people = length(logs), p = 1, ratio = NA, low = NA, high = NA, not_worse = NA,
                    not_better = NA)
  if (length(logs) < 5) return(row)
  row$p <- t.test(logs)$p.value
  row$ratio <- exp(mean(logs))
  row[c("low", "high")] <- as.list(exp(t.test(logs)$conf.int))
  if (hypothesis$margin > 0) {
    worse <- log1p(hypothesis$margin)
    row$not_worse <- t.test(logs, mu = worse, alternative = "less")$p.value
    row$not_better <- t.test(logs, mu = -worse, alternative = "greater")$p.value
    row$p <- if (hypothesis$kind == "not-worse") row$not_worse else max(row$not_worse, row$not_better)
  }
  row
}
planned <- file.path(dirname(file), "hypotheses.csv")
if (file.exists(planned)) {
  hypotheses <- read.csv(planned, na.strings = "", check.names = FALSE, stringsAsFactors = FALSE)
  rows <- lapply(seq_len(nrow(hypotheses)), function(i) test_hypothesis(hypotheses[i, ]))
  tests <- do.call(rbind, rows)
  tests$p_holm <- p.adjust(tests$p, "holm")
  cat("\nHypotheses (ratio with 95 % interval; not_worse and not_better: one-sided tests):\n")
  print(data.frame(hypothesis = hypotheses$hypothesis, round(tests, 4)), row.names = FALSE)
}
if (nlevels(trials$participant) < 2 || nlevels(trials$condition) < 2) {
  cat("The model needs two participants and two conditions.\n")
  quit(status = 0)
}

fixed <- if (nlevels(trials$session) > 1) "condition * session" else "condition"
shape <- if (nlevels(trials$shape) > 1) " + (1 | shape)" else ""
# From the model that the design asks for to simpler ones, until one is not singular.
random <- c(paste0("(1 + condition | participant)", shape),
            paste0("(1 + condition || participant)", shape),
            paste0("(1 | participant)", shape),
            "(1 | participant)")
model <- NULL
for (terms in unique(random)) {
  formula <- as.formula(paste("log(err_mean_mm) ~", fixed, "+", terms))
  fit <- try(suppressMessages(suppressWarnings(lmer(formula, data = trials))), silent = TRUE)
  if (inherits(fit, "try-error")) next
  model <- fit
  if (!isSingular(fit)) break
}
if (is.null(model)) stop("no model can be fitted to these trials")
cat("Model:", deparse1(formula(model)), "\n")
if (isSingular(model)) cat("The fit is singular: too few data for these random effects.\n")

estimate <- fixef(model)
error <- sqrt(diag(as.matrix(vcov(model))))
table <- data.frame(ratio = exp(estimate), low = exp(estimate - qnorm(0.975) * error),
                    high = exp(estimate + qnorm(0.975) * error))[-1, ]
cat("\nRatios of errors with 95 % intervals:\n")
print(round(table, 3))
