//! How far a picture is from the truth: NRMSE, block NRMSE, bias, 95th percentile, FLIP.
