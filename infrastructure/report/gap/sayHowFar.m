% SAYHOWFAR  Says how much of the gap the cause closes, and what placebos close.
%
% CALL: sayHowFar (CURE, GAPPROBLEM, SAY)
%
%   CURE        of measureCure; [] where nothing can be compared
%   GAPPROBLEM  see newGapProblem
%   SAY         function handle that takes one line of text

function sayHowFar (cure, gapProblem, say)
  if isempty (cure)
    return
  end
  tell = @(varargin) say (sprintf (varargin{:}));
  nouns = {'gap', 'change'};
  of = nouns{1 + ~isempty(gapProblem.reference)};
  how = {'on the surrogates, not yet by DEM', 'by DEM'};
  noise = '';
  if cure.free ~= 0
    noise = sprintf (', noise makes %.1f -> %.1f %%', ...
                     100 * [cure.floor, cure.floorAfter]);
  end
  tell ('');
  tell ('HOW FAR with %s (%s): deviation %.1f %% -> %.1f %% of the range%s', ...
        cure.effect, how{1 + cure.verifiedByDEM}, ...
        100 * [cure.before, cure.after], noise);
  sayClosure ('calibrated targets', cure, of, tell);
  if ~isempty (cure.heldOut)
    sayHeldOut (gapProblem, cure, of, tell);
  end
  for p = cure.placebos
    sayPlacebo (p, cure.verifiedByDEM, of, tell);
  end
end

function sayClosure (name, c, of, tell)
  if c.free == 0
    text = 'cannot be judged from so few: the fit has as many unknowns';
  elseif ~isfinite (c.closure)
    text = sprintf ('too near noise for a share (p = %.2g, largest z %.1f)', ...
                    c.gapP, c.largestZ);
  elseif diff (c.interval90) > 0.5
    text = sprintf ('cannot be told: %.0f %% of the %s (90 %%: %.0f to %.0f)', ...
                    100 * c.closure, of, 100 * c.interval90);
  elseif c.closure >= 0.995
    text = sprintf ('all of the %s closed (90 %%: from %.0f %%)', of, ...
                    100 * min (1, c.interval90(1)));
  else
    share = 100 * [c.closure, c.interval90(:)'];
    text = sprintf ('%.0f %% of the %s closed (90 %%: %.0f to %.0f)', ...
                    share(1), of, share(2:3));
  end
  tell ('  %-26s %s', name, text);
end

% A share of few numbers says little: then each of them.
function sayHeldOut (gapProblem, cure, of, tell)
  held = cure.targets(ismember ([cure.targets.target], gapProblem.heldOut));
  if numel (held) > 8
    sayClosure ('held-out targets', cure.heldOut, of, tell);
    return
  end
  tell ('  %-28s %11s %11s %11s %9s', 'held out', 'measured', 'without', ...
        'with', 'sd');
  for t = held
    tell ('  %-28s %11.5g %11.5g %11.5g %9.2g', ...
          gapProblem.targetNames{t.target}, gapProblem.value(t.target), ...
          t.before, t.after, t.sd);
  end
end

function sayPlacebo (p, isByDEM, of, tell)
  if ~isfinite (p.closure)
    return
  end
  share = sprintf ('%.0f %%', 100 * p.closure);
  if p.closure >= 0.995
    share = ['all of the ', of];
  elseif p.closure <= 0.005
    share = 'nothing';
  end
  tell (['  placebo %s closes %s (%.0f %% expected beside the right ' ...
         'cause), %.0f to %.0f points less than the cause (90 %%)%s'], ...
        p.effect, share, 100 * [p.expected, p.difference90], ...
        repmat (', on the surrogates', 1, isByDEM && ~p.verifiedByDEM));
  if isfinite (p.logRatio)
    % beyond a thousand the shape of the noise decides, which nobody knows
    times = sprintf ('%.3g times', exp (p.logRatio));
    if p.logRatio > log (1000)
      times = 'more than 1000 times';
    elseif p.logRatio < -log (1000)
      times = 'less than a thousandth';
    end
    tell (['    held-out targets are %s as likely with the cause as with ' ...
           'it'], times);
  end
  if p.against
    tell ('    it closes as much as the cause: the name is in doubt');
  end
end

%!test
%! % each held-out target where they are few, else their share; of a change
%! cure = struct ('effect', 'tilt', 'free', 3, 'closure', 0.5, ...
%!                'interval90', [0.4, 0.6], 'gapP', 0.2, 'largestZ', 1.5, ...
%!                'before', 0.2, 'after', 0.1, 'floor', 0.05, ...
%!                'floorAfter', 0.04, 'verifiedByDEM', true);
%! cure.heldOut = setfield (cure, 'closure', NaN);
%! cure.targets = struct ('target', num2cell (1:9), 'before', 3, ...
%!                        'after', 4, 'sd', 0.1);
%! cure.placebos = struct ('effect', 'drag', 'closure', 1, 'expected', 0.3, ...
%!                         'difference90', [0.1, 0.2], 'logRatio', -9, ...
%!                         'against', true, 'verifiedByDEM', false);
%! problem = struct ('reference', [], 'heldOut', 9, 'value', 10:18, ...
%!                   'targetNames', {{'a', 'b', 'c', 'd', 'e', 'f', 'g', ...
%!                                    'h', 'i'}});
%! said = evalc ('sayHowFar (cure, problem, @disp)');
%! for text = {'with tilt (by DEM): deviation 20.0 % -> 10.0 %', ...
%!             '50 % of the gap closed (90 %: 40 to 60)', ...
%!             '18           3           4       0.1', ...
%!             'placebo drag closes all of the gap (30 % expected', ...
%!             'cause (90 %), on the surrogates', 'less than a thousandth'}
%!   assert (! isempty (strfind (said, text{1})), text{1});
%! end
%! [problem.heldOut, problem.reference] = deal (1:9, 1);
%! said = evalc ('sayHowFar (cure, problem, @disp)');
%! assert (! isempty (strfind (said, 'too near noise for a share (p = 0.2')));
%! assert (! isempty (strfind (said, '50 % of the change closed')));
