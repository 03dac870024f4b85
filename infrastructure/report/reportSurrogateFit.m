% REPORTSURROGATEFIT  Says how far the surrogates can be trusted.
%
% CALL: reportSurrogateFit (SURROGATES, DATA, PROBLEM, SAY [, REST])
%
%   SURROGATES  1 x T struct array, see fitSurrogate
%   DATA        see newData
%   PROBLEM     see newProblem
%   SAY         function handle that takes one line of text
%   REST        runs that no surrogate was given, see importExisting
%
% Q2 is the share of the responses' variance that is predicted when each run is
% left out in turn: 1 perfect, 0 no better than the mean.
%
% Where a part of the runs was left out (thinRuns), the surrogates are compared
% with these, too: what was lost with them.

function reportSurrogateFit (surrogates, data, problem, say, rest)
  tell = @(varargin) say (sprintf (varargin{:}));
  say ('');
  say ('Kriging models (each run left out in turn)');
  tell ('  %-28s %6s %9s   %s', 'target', 'Q2', 'noise (%)', ...
        'range of the responses');
  shown = shownTargets (struct ('targets', ...
                                struct ('curve', num2cell (problem.curve), ...
                                        'at', num2cell (problem.coordinate))));
  for t = shown
    s = surrogates(t);
    tell ('  %-28s %6.2f %9.2f   %.4g to %.4g', problem.targetNames{t}, ...
          s.Q2, 100 * sqrt (s.noiseVar) / abs (mean (s.z)), min (s.z), ...
          max (s.z));
  end
  if numel (shown) < numel (surrogates)
    tell ('  (of %d points on curves three each)', sum (problem.curve > 0));
  end
  if rows (data.X) > 2000                % see fitSurrogates
    tell (['  WARNING: of %d runs 2000 are fitted, the nearest to ' ...
           'the targets and others'], rows (data.X));
  end
  if nargin > 4 && rows (rest.X) > 0
    sayLoss (surrogates, rest, problem, tell);
  end
  warnOf (surrogates, data, problem, shown, tell);
end

function sayLoss (surrogates, rest, problem, tell)
  share = NaN (2, numel (surrogates));
  for t = 1:numel (surrogates)
    s = surrogates(t);
    P = rest.X;
    if ~isempty (s.level)
      P(:, end + 1) = unitLevel (problem.coarse, rest.E, t);
    end
    miss = rest.Z(:, t) - predictSurrogate (s, P);
    rms = sqrt ([mean(miss(isfinite (miss)).^2); s.noiseVar]);
    share(:, t) = 100 * rms / (max (s.z) - min (s.z));
  end
  [most, t] = max (share(1, :));
  if ~isnan (most)
    tell (['  The %d runs left out are off the surrogates by %.2g ' ...
           '%% of the range at most (rms, %s; the scatter of a run ' ...
           'is %.2g %%)'], rows (rest.X), most, problem.targetNames{t}, ...
          share(2, t));
  end
end

function warnOf (surrogates, data, problem, shown, tell)
  for t = shown
    name = problem.targetNames{t};
    z = data.Z(:, t);
    if problem.value(t) < min (z) || problem.value(t) > max (z)
      tell (['  WARNING: the target %g of %s is outside the range ' ...
             'of the plan (%.4g to %.4g)'], problem.value(t), name, min (z), ...
            max (z));
    end
    if ~(surrogates(t).Q2 > 0.5)
      tell (['  WARNING: the surrogate of %s predicts poorly (Q2 ' ...
             '%.2f): more samples, or a wider box'], name, surrogates(t).Q2);
    end
  end
end

%!test
%! % what the runs tell that were left out
%! pkg load stk
%! rand ('twister', 1);
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('name', 'z', 'value', 1.5, 'tol', 0.01));
%! problem = newProblem (C, []);
%! X = [0; 1; rand(18, 1)];
%! data = addRows (newData (1, 1), X, 1 + X, ones (20, 1), 'plan');
%! s = fitSurrogates (data, problem);
%! rest = struct ('X', [0.2; 0.4; 0.6], 'Z', [1.3; 1.5; NaN], ...
%!                'E', zeros (3, 0));
%! text = evalc ('reportSurrogateFit (s, data, problem, @disp, rest);');
%! assert (~isempty (strfind (text, 'The 3 runs left out')), text);
%! assert (~isempty (strfind (text, 'by 10 % of the range at most (rms, z;')));
%! text = evalc ('reportSurrogateFit (s, data, problem, @disp);');
%! assert (isempty (strfind (text, 'left out are')));
