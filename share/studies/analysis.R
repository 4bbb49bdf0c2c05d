#!/usr/bin/env Rscript
# Fits a mixed model to trials.csv, which is in the folder of this script or is the first argument.
# Prints how many times as large the error is as in the first condition and session, with 95 %
# intervals (Wald). Requires the package lme4.
suppressPackageStartupMessages(library(lme4))

arguments <- commandArgs()
script <- sub("^--file=", "", grep("^--file=", arguments, value = TRUE))
given <- commandArgs(trailingOnly = TRUE)
file <- if (length(given) > 0) given[1] else file.path(dirname(script[1]), "trials.csv")

all <- read.csv(file, na.strings = "", check.names = FALSE, stringsAsFactors = FALSE)
trials <- all[as.logical(all$valid) & !as.logical(all$is_practice) & !is.na(all$err_mean_mm) &
                all$err_mean_mm > 0, ]
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
