% REPORTSURROGATES  One line of text a surrogate.
%
% CALL: lines = reportSurrogates (surrogates)
%
% surrogates  1 x T struct array of fitSurrogates
% lines       cellstr: name, leave-one-out Q2, noise of a run, trend, covariance
%
% See also: fitSurrogates, checkSurrogates

function lines = reportSurrogates (surrogates)
  lines = cell (1, numel (surrogates));
  for t = 1:numel (surrogates)
    s = surrogates(t);
    lines{t} = sprintf (['%-20s Q2 %5.3f   noise of a run %.3g (%.2g %%)   ' ...
                         'largest standardised residual %.1f   %s, %s'], ...
                        s.name, s.Q2, sqrt (s.noiseVar), ...
                        100 * sqrt (s.noiseVar) / abs (mean (s.z)), ...
                        max (abs (s.looStd)), s.trend, s.covariance);
  end
end
