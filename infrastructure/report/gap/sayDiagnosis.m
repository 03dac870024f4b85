% SAYDIAGNOSIS  Tells a plant engineer what the diagnosis has found.
%
% CALL: sayDiagnosis (DIAGNOSIS, CASE, SAY)
%
%   DIAGNOSIS  of diagnoseMatrices, with its field verdict (decideCase)
%   CASE       struct with the field folder
%   SAY        function handle that takes one line of text
%
% Four plain lines first: where, what, how much is closed, to do. Then tables.

function sayDiagnosis (diagnosis, Case, say)
  tell = @(varargin) say (sprintf (varargin{:}));
  sayPlain (diagnosis.verdict, ...
            madeByText (jsonAt (diagnosis, {'which', 'cause'})), say);
  sayWhere (diagnosis, tell);
  if isfile (fullfile (Case.folder, 'results', 'calibration.json'))
    say (['  ', whyTwoSets()]);
  end
  sayWhich (diagnosis, tell);
  if ~isempty (diagnosis.verdict.cause.closed)
    sayHowFar (diagnosis.howFar, diagnosis.gapProblem, say);
  end
  if ~isempty (jsonAt (diagnosis, {'level'}))
    say ('');
    say (['LEVEL: ', levelText(diagnosis.level)]);
  end
  sayConditions (diagnosis.others, tell);
  say ('');
  sayNext (diagnosis, say);
  say ('');
  tell ('DEM runs: %d new, %d failed, %.1f core-minutes', ...
        diagnosis.budget.new, diagnosis.budget.failed, ...
        diagnosis.budget.coreSeconds / 60);
  say (['Details: ', fullfile(Case.folder, 'gap', 'gap.json'), ...
        ' and the tables beside it']);
end

% Where no test would tell, what is known of the family.
function sayNext (diagnosis, say)
  say (['NEXT TEST: what would tell most about the kind of cause (1 bit: ', ...
        'as much as a sure yes or no)']);
  tests = diagnosis.next(:)';
  if isempty (tests) || tests(1).gain < 0.2
    say (['  Nothing is advised: no test tells 0.2 bit. ', ...
          tellApart(diagnosis.which.effects)]);
  end
  for t = tests(1:min (3, end))
    say (['  ', nextText(t)]);
  end
  if ~isempty (jsonAt (diagnosis, {'nextFile'}))
    say (['  Fill in what was measured: ', diagnosis.nextFile]);
    say ('  and start decalioc diagnose again: the test is part of the case.');
  end
end

% Where more than one condition is laid beside the reference.
function sayConditions (others, tell)
  if numel (others.conditions) < 2
    return
  end
  tell ('');
  tell ('CONDITIONS, beside the reference:');
  for one = others.conditions
    tell ('  %-20s %s  %s', one.name, one.verdict, ...
          strjoin (one.effects, ', '));
  end
  for one = others.order
    tell ('  more %s in %s than in %s, probability %.2f', one.effect, ...
          one.more, one.less, one.probability);
  end
end

function sayPlain (v, madeBy, say)
  cause = v.cause;
  say ('');
  say (['MISSES  ', cause.where]);
  say (['CAUSE   ', cause.sentence]);
  if ~isempty (madeBy)
    say (['        ', madeBy]);
  end
  if ~isempty (cause.closed)
    say (['CLOSED  ', cause.closed]);
  end
  say (['NEXT    ', v.action]);
  if ~isempty (cause.cannotSee)
    say (['        Cannot be seen here, so neither found nor excluded: ', ...
          strjoin(cause.cannotSee, ', ')]);
  end
  cellfun (@(text) say (['        ', text]), cause.untested);
end

function sayWhere (diagnosis, tell)
  where = diagnosis.where;
  gapProblem = diagnosis.gapProblem;
  words = {'the calibrated model', '', 'model'};
  if ~isempty (gapProblem.reference)
    words = {'the reference', ' new', 'foretold'};
  end
  tell ('');
  tell (['WHERE: noise alone would make %s miss the %d%s measurements by ' ...
         'as much with p = %.3g'], words{1}, numel (gapProblem.used), ...
        words{2}, where.p);
  tell ('  %-28s %11s %11s %7s %7s  ', 'target', 'measured', words{3}, 'z', ...
        'p');
  for T = diagnosedTargets (diagnosis)
    mark = '';
    if T.p < 0.05
      mark = '<-- off';
    elseif T.blind
      mark = 'blind: parameters can hide an error here';
    end
    if strcmp (T.role, 'holdout')
      mark = regexprep ([mark, ', held out'], '^, ', '');
    end
    tell ('  %-28s %11.5g %11.5g %7.1f %7.3f  %s', T.name, T.measured, ...
          T.predicted, T.z, T.p, mark);
  end
  tell (['  z: miss in units of all noise; p: how often noise alone makes ', ...
         'one of the fitted (or held-out) ones as odd']);
  [~, order] = sort (-[where.benches.size]);
  for b = where.benches(order)
    tell ('  bench %-22s p = %.3f, off by %.1f sd', ...
          gapProblem.benchNames{b.bench}, b.p, b.size);
  end
  why = {'none of its runs gave a result', 'it was never run to its end'};
  for b = where.out(:)'
    isNever = any (strcmp (b{1}, where.neverRun));
    tell ('  %s is out, for %s', b{1}, why{1 + isNever});
  end
  if ~isempty (where.conflict.odd)
    tell ('  %s disagrees with all other benches', ...
          gapProblem.benchNames{where.conflict.odd});
  end
  if ~isempty (where.side.atLimit)
    tell ('  at the limit of their range: %s', ...
          strjoin (where.side.atLimit, ', '));
  end
end

function sayWhich (diagnosis, tell)
  w = diagnosis.which;
  tell ('');
  tell ('WHICH: %s', diagnosis.verdict.cause.word);
  if ~isempty (w.partners)
    tell ('  together with one of: %s', strjoin (w.partners, ', '));
  end
  [~, order] = sort (-diagnosis.screen.gain);
  tell ('  %-20s %11s  %s', 'effect', 'probability', ...
        'how strong it would be (90 % interval)');
  null = {'no gap', 'nothing changed'};
  isChange = ~isempty (diagnosis.gapProblem.reference);
  tell ('  %-20s %11.3f', null{1 + isChange}, w.posterior.null);
  for k = order
    s = w.strength(k);
    p = w.posterior.(matlab.lang.makeValidName (s.name));
    tell ('  %-20s %11.3f  %s', s.name, p, ...
          strengthText (s, diagnosis.screen.smallest(k), ...
                        diagnosis.gapProblem));
  end
  tell ('  %-20s %11.3f', 'none of the listed', w.posterior.unlisted);
end

function text = strengthText (s, smallest, gapProblem)
  text = 'cannot be seen';
  if isinf (smallest) || isempty (s.values)
    return
  elseif strcmp (s.says, 'nothing')
    text = sentence ('strength.unknown');
    return
  end
  e = gapProblem.effects(strcmp ({gapProblem.effects.name}, s.name));
  if isfield (e, 'label') && columns (s.values) == 1
    text = effectText (e.label, e.unit, s.values);
  else
    text = sprintf ('%.2f of its range (%.2f to %.2f)', s.value, s.interval90);
  end
  if strcmp (s.says, 'least')
    text = sentence ('strength.least', struct ('amount', text));
  end
end

% Of each family of docs/effects.md one member: the others look alike on most
% benches.
function text = tellApart (names)
  known = {{'rolling', 'shape'}, ...
           ['measure the bulk density: clumps pack denser, rolling ' ...
            'friction looser']; ...
           {'cohesion', 'liquidBridge', 'wallAdhesion'}, ...
           ['repeat a test after a rest (moisture, charge), or along a ' ...
            'smooth wall']; ...
           {'sizeSpread', 'meanSize'}, 'measure a series of openings'; ...
           {'tilt', 'cameraRoll'}, ...
           'put a level on the camera, or turn the test round'; ...
           {'moistDensity', 'gain'}, ...
           'put a reference weight on the balance'};
  parts = {};
  for i = 1:rows (known)
    if any (ismember (names, known{i, 1}))
      parts{end + 1} = sprintf ('%s: %s', strjoin (known{i, 1}, ', '), ...
                                known{i, 2});
    end
  end
  text = strjoin (parts, '; ');
end

%!test
%! % where no gap is told, nothing is said of how far it is closed
%! list = verdictCase ();
%! s = list(strcmp ({list.name}, 'missed, no gap'));
%! s.gap.howFar.effect = 'cohesion';
%! raw = standInCase (tempname ());
%! text = verdictConsole (s, newCase (raw));
%! assert (! isempty (strfind (text, 'WHICH: No gap seen')));
%! assert (isempty (strfind (text, 'HOW FAR')));
%! % where no test tells, what is known of the families of the effects
%! s.gap.next = [];
%! s.gap.which.effects = {'cohesion', 'gain'};
%! text = verdictConsole (s, newCase (raw));
%! assert (! isempty (regexp (text, ['Nothing is advised: [^;]*after a ' ...
%!                            'rest[^;]*; moistDensity[^;]*balance\n'])), text);
%! s.gap.which.effects = {'drag'};
%! text = verdictConsole (s, newCase (raw));
%! assert (! isempty (strfind (text, "tells 0.2 bit. \n")), text);
