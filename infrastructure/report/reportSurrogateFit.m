% REPORTSURROGATEFIT  Says how far the surrogates can be trusted.
%
% CALL: reportSurrogateFit (SURROGATES, DATA, PROBLEM, SAY)
%
%   SURROGATES  1 x T struct array, see fitSurrogate
%   DATA        see newData
%   PROBLEM     see newProblem
%   SAY         function handle that takes one line of text
%
% Q2 is the share of the responses' variance that is predicted when each run is
% left out in turn: 1 perfect, 0 no better than the mean.
%
% See also: fitSurrogates, runPlan

function reportSurrogateFit (surrogates, data, problem, say)
  say ('');
  say ('Kriging models (each run left out in turn)');
  say (sprintf ('  %-28s %6s %9s   %s', 'target', 'Q2', 'noise (%)', ...
                'range of the responses'));
  shown = shownTargets (problem);
  for t = shown
    s = surrogates(t);
    say (sprintf ('  %-28s %6.2f %9.2f   %.4g to %.4g', ...
                  problem.targets(t).name, s.Q2, ...
                  100 * sqrt (s.noiseVar) / abs (mean (s.z)), ...
                  min (s.z), max (s.z)));
  end
  if numel (shown) < numel (surrogates)
    say (sprintf ('  (of %d points on curves three each)', ...
                  sum (problem.curve > 0)));
  end
  warnOf (surrogates, data, problem, shown, say);
end

function warnOf (surrogates, data, problem, shown, say)
  for t = shown
    name = problem.targets(t).name;
    z = data.Z(:, t);
    if problem.value(t) < min (z) || problem.value(t) > max (z)
      say (sprintf (['  WARNING: the target %g of %s is outside the range ' ...
                     'of the plan (%.4g to %.4g)'], problem.value(t), name, ...
                    min (z), max (z)));
    end
    if ~(surrogates(t).Q2 > 0.5)
      say (sprintf (['  WARNING: the surrogate of %s predicts poorly (Q2 ' ...
                     '%.2f): more samples, or a wider box'], name, ...
                    surrogates(t).Q2));
    end
  end
end
