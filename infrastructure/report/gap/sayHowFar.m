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
  if ~isempty (gapProblem.reference)
    say = @(text) say (strrep (text, 'of the gap', 'of the change'));
  end
  how = 'on the surrogates, not yet by DEM';
  if cure.verifiedByDEM
    how = 'by DEM';
  end
  say ('');
  noise = sprintf (', noise makes %.1f -> %.1f %%', 100 * cure.floor, ...
                   100 * cure.floorAfter);
  if cure.free == 0
    noise = '';
  end
  say (sprintf (['HOW FAR with %s (%s): deviation %.1f %% -> %.1f %% of ' ...
                 'the range%s'], cure.effect, how, 100 * cure.before, ...
                100 * cure.after, noise));
  sayClosure ('calibrated targets', cure, say);
  if ~isempty (cure.heldOut)
    sayHeldOut (gapProblem, cure, say);
  end
  for p = cure.placebos
    sayPlacebo (p, cure.verifiedByDEM, say);
  end
end

function sayClosure (name, c, say)
  if c.free == 0
    say (sprintf (['  %-26s cannot be judged from so few: the fit has as ' ...
                   'many unknowns'], name));
  elseif isfinite (c.closure) && c.closure >= 0.995
    say (sprintf ('  %-26s all of the gap closed (90 %%: from %.0f %%)', ...
                  name, 100 * min (1, c.interval90(1))));
  elseif isfinite (c.closure)
    say (sprintf ('  %-26s %.0f %% of the gap closed (90 %%: %.0f to %.0f)', ...
                  name, 100 * c.closure, 100 * c.interval90));
  else
    say (sprintf (['  %-26s too near noise for a share (p = %.2g, largest ' ...
                   'z %.1f)'], name, c.gapP, c.largestZ));
  end
end

% A share of few numbers says little: then each of them.
function sayHeldOut (gapProblem, cure, say)
  held = cure.targets(ismember ([cure.targets.target], gapProblem.heldOut));
  if numel (held) > 8
    sayClosure ('held-out targets', cure.heldOut, say);
    return
  end
  say (sprintf ('  %-28s %11s %11s %11s %9s', 'held out', 'measured', ...
                'without', 'with', 'sd'));
  for t = held
    say (sprintf ('  %-28s %11.5g %11.5g %11.5g %9.2g', ...
                  gapProblem.targetNames{t.target}, ...
                  gapProblem.value(t.target), t.before, t.after, t.sd));
  end
end

function sayPlacebo (p, isByDEM, say)
  if ~isfinite (p.closure)
    return
  end
  text = sprintf (['  placebo %s closes %s (%.0f %% expected beside ' ...
                   'the right cause), %.0f to %.0f points less than the ' ...
                   'cause (90 %%)'], p.effect, shareText (p.closure), ...
                  100 * [p.expected, p.difference90]);
  if isByDEM && ~p.verifiedByDEM
    text = [text, ', on the surrogates'];
  end
  say (text);
  if isfinite (p.logRatio)
    say (['    held-out targets are ', timesText(p.logRatio), ...
          ' as likely with the cause as with it']);
  end
  if p.against
    say ('    it closes as much as the cause: the name is in doubt');
  end
end

function text = shareText (closure)
  text = sprintf ('%.0f %%', 100 * closure);
  if closure >= 0.995
    text = 'all of the gap';
  elseif closure <= 0.005
    text = 'nothing';
  end
end

% Beyond a thousand the shape of the noise decides, which nobody knows.
function text = timesText (logRatio)
  text = sprintf ('%.3g times', exp (logRatio));
  if logRatio > log (1000)
    text = 'more than 1000 times';
  elseif logRatio < -log (1000)
    text = 'less than a thousandth';
  end
end

%!test
%! [~, text] = situationPage ('missed, named');
%! assert (! isempty (strfind (text, ...
%!         'deviation 23.1 % -> 4.2 % of the range, noise makes 6.6')));
%! assert (! isempty (strfind (text, ...
%!         '90 % of the gap closed (90 %: 80 to 110)')));
%! assert (! isempty (strfind (text, ...
%!         'placebo tilt closes nothing (30 % expected')));
%! assert (! isempty (strfind (text, 'more than 1000 times as likely')), text);
%!test
%! [~, text] = situationPage ('missed, as many unknowns as targets');
%! assert (! isempty (strfind (text, 'cannot be judged from so few')), text);
%! assert (isempty (strfind (text, 'range, noise makes')), text);
