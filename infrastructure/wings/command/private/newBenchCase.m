% NEWBENCHCASE  Words of a case of the toolbox's own test rigs.
%
% CALL: WORDS = newBenchCase (ROOT, NAMES)
%       WORDS = newBenchCase (ROOT, NAMES, ASK)
%
%   ROOT   folder of the toolbox (text)
%   NAMES  names of the rigs with commas between (text): 'Heap,Drum'
%   ASK    handle (QUESTION, DEFAULT, RULE -> text): what a person says at a
%          terminal; by default all defaults are taken. RULE is a handle (TEXT)
%          -> [TEXT, FAULT], see amountIn
%   WORDS  scalar struct of texts for fillTemplate of templates/benchCase; TAKEN says
%          what nobody was asked for: tolerances of what was measured, limits
%
% measured.csv gets a line for each result, without a value: what is left empty
% is predicted only. Its tolerance is twice what one run scatters by, at least 2
% per cent: a smaller one needs many runs of each parameter set.
%
% Errors: DEcalioc:newBenchCase:badValue, those of listBenches

function words = newBenchCase (root, names, ask)
  if nargin < 3
    ask = @(question, default, rule) default;
  end
  benches = listBenches (root, eachOnce (names));
  quoted = @(list) strjoin (strcat ('''', list, ''''), ', ');
  words = struct ('FORM', 'm', 'BENCHES', strjoin ({benches.name}, ', '));
  [words.RADIUS, words.DENSITY, bulk] = askGrains (ask);
  for k = 1:numel (benches)
    benches(k).sizes = askSizes (benches(k), str2double (words.DENSITY), ask);
    sizes = [{benches(k).sizes.name}; ...
             num2cell(str2double ({benches(k).sizes.value}))];
    benches(k).results = resultInfo (benches(k).folder, struct (sizes{:}));
  end
  words.MODELS = quoted ({benches.name});
  words.CPUS = strjoin (repmat ({'1'}, 1, numel (benches)), ', ');
  words.SIZES = sizeLines (benches);
  [rows, tols] = arrayfun (@(bench) rowsOf (bench, ask, bulk), benches, ...
                           'UniformOutput', false);
  words.ROWS = [rows{:}];
  sought = {'coefFrictionPP', '0.2', '0.8'; 'coefRollingFrictionPP', '0.02', '0.30'};
  words.ASSIGN = quoted (sought(:, 1)');
  words.LOW = strjoin (sought(:, 2)', ', ');
  words.HIGH = strjoin (sought(:, 3)', ', ');
  words.TAKEN = [takenLines([tols{:}], sought), openLine(root, {benches.name}, sought(:, 1)')];
  words.EFFECTS = effectLines (quoted, candidatesOf (benches));
end

% What a balance and a calliper give; the density of a grain follows from the bulk.
function [radius, density, bulk] = askGrains (ask)
  diameter = ask ('diameter of a grain, m (or 4 mm)', '0.004', ...
                  @(text) sizeIn (text, 'm'));
  radius = sprintf ('%.6g', str2double (diameter) / 2);
  bulk = ask (['bulk density as poured, kg/m3 (empty: you know the density of a ' ...
               'grain)'], '', @(text) amountIn (text, 'kg/m3'));
  [usual, from] = deal ('1200', 'not of the bulk');
  if ~isempty (bulk)
    usual = sprintf ('%.4g', str2double (bulk) / 0.6);
    from = sprintf ('if grains fill 0.6 of the volume, %s kg/m3 of bulk make %s', ...
                    bulk, usual);
  end
  density = ask (sprintf ('density of a grain, kg/m3 (%s)', from), usual, ...
                 @(text) sizeIn (text, 'kg/m3'));
end

function names = eachOnce (names)
  names = strtrim (strsplit (names, ','));
  if numel (unique (names)) < numel (names)
    error ('DEcalioc:newBenchCase:badValue', ...
           '--bench must name each test rig once, got %s.', strjoin (names, ','));
  end
end

% A variable that two rigs share is one variable of the case.
function text = sizeLines (benches)
  [text, seen] = deal ('', {'densityP', 'radiusP'});
  for bench = benches
    sizes = bench.sizes(~ismember ({bench.sizes.name}, seen));
    seen = [seen, {sizes.name}];
    text = [text, sprintf("  %% %s\n", bench.title)];
    for one = sizes
      left = sprintf ('  modelVars.%s = %s;', one.name, one.value);
      text = [text, left, repmat(' ', 1, max (36 - numel (left), 1)), ...
              repmat(['% ', one.remark], 1, ~isempty (one.remark)), "\n"];
    end
  end
  text = regexprep (text, ' +\n', "\n");
end

% One line a reading, in the unit that was typed; the tolerance stands in the first.
% TOLS: those of what was measured, as one says them.
function [text, tols] = rowsOf (bench, ask, bulk)
  [text, tols] = deal ('', {});
  for k = 1:numel (bench.results)
    one = bench.results(k);
    usual = repmat (bulk, 1, strcmp (one.name, 'bulkDensity'));
    hint = repmat ('all readings: 31.4, 32.0, 30.6; ', 1, k == 1);
    said = ask (sprintf ('%s: %s, measured, %s (%sempty: not measured)', ...
                         bench.name, inTurns (one.text), one.unit, hint), usual, ...
                @(text) readingsIn (text, one.unit));
    if ischar (said)
      said = readingsIn (said, one.unit);
    end
    tol = toleranceOf (bench, k, said.unit);
    if ~isempty (said.values)
      tols{end + 1} = sprintf ('%s %s %s', bench.name, one.name, ...
                               regexprep (tol, {'%', 'abs'}, {' %', said.unit}));
    end
    readings = [said.values; said.sd];
    if isempty (readings)
      readings = {''; ''};
    end
    for reading = readings
      text = [text, sprintf('%s,%s,%s,%s,%s,,,%s\n', bench.name, one.name, reading{:}, ...
                            said.unit, tol)];
      tol = '';
    end
  end
end

% A speed was asked for in turns, and is said in turns.
function text = inTurns (text)
  speed = str2double (regexp (text, '\S+(?= rad/s)', 'match', 'once'));
  text = regexprep (text, '\S+ rad/s( \(\S+ rpm\))?', ...
                    sprintf ('%.3g turns per minute', speed * 30 / pi));
end

function text = toleranceOf (bench, k, unit)
  tol = 2 * bench.sd(k) / abs (bench.mean(k));
  text = sprintf ('%.0f%%', ceil (100 * max (tol, 0.02)));
  if tol > 0.4
    text = sprintf ('%.1g abs', 2 * bench.sd(k) * ...
                    unitFactor (bench.results(k).unit, unit));
  end
end

function text = takenLines (tols, sought)
  text = sprintf (["limits     %s (loadInput.m, part 3; smooth round grains as of glass: from ", ...
                   "0.05 and 0)\n"], ...
                  strjoin (strcat (sought(:, 1), {' '}, sought(:, 2), {' to '}, ...
                                   sought(:, 3))', ', '));
  if ~isempty (tols)
    text = sprintf (["tolerance  %s: twice what one run of these rigs scatters by, at " ...
                     "least 2 %% (measured.csv, column tol)\n%s"], ...
                    strjoin (tols, ', '), text);
  end
end

% Parameters that these rigs hardly tell (share/power.csv: 45 % is nothing).
function text = openLine (root, names, sought)
  text = '';
  [header, cells] = readCsvTable (fullfile (root, 'share', 'power.csv'));
  of = @(name) cells(:, strcmp (header, name));
  isOurs = cellfun (@(b) all (ismember (strsplit (b, '+'), names)), of ('benches'));
  least = cellfun (@(p) min (str2double (of ('share')(isOurs & strcmp (of ('name'), p)))), ...
                   sought, 'UniformOutput', false);
  isOpen = cellfun (@(share) ~isempty (share) && share > 0.4, least);
  if any (isOpen)
    told = cellfun (@(p, share) sprintf ('%s only to +- %.0f %%', p, 100 * share), ...
                    sought(isOpen), least(isOpen), 'UniformOutput', false);
    text = sprintf (["told       %s of its range (45 %%: not at all); decalioc plan says " ...
                     "which further rig tells more, such as --bench Heap,Drum\n"], ...
                    strjoin (told, ', '));
  end
end

% Effects that one rig at least can express, the commonest ones.
function names = candidatesOf (benches)
  names = {'cohesion', 'liquidBridge', 'wallAdhesion', 'shape', ...
           'sizeSpread', 'meanSize', 'fill', 'tilt', 'opening', ...
           'liftSpeed', 'lidWeight', 'speedError', 'timeOffset', 'cameraRoll'};
  names = names(effectsOfModel ({benches.folder}, names));
end

function text = effectLines (quoted, names)
  text = '';
  for k = 1:4:numel (names)
    part = quoted (names(k:min (k + 3, end)));
    text = [text, repmat([", ...\n", blanks(13)], 1, k > 1), part];
  end
end

%!function text = ifelseText (question, default)
%!  text = default;
%!  text = [text, repmat('31', 1, ~isempty (strfind (question, 'inclination')))];
%!  if ~isempty (strfind (question, 'diameter of a grain'))
%!    text = '0.002';
%!  elseif ~isempty (strfind (question, 'bulk density as'))
%!    text = '690';
%!  elseif ~isempty (strfind (question, 'stays on the plate'))
%!    text = '14.1, 13.9 g';
%!  end
%!endfunction
%!shared root
%! root = fileparts (fileparts (which ('startToolbox')));
%!test
%! words = newBenchCase (root, 'Heap, Drum');
%! assert (words.MODELS, '''Heap'', ''Drum''');
%! assert (words.CPUS, '1, 1');
%! assert (~isempty (strfind (words.ROWS, "Heap,slope,,,deg,,,7%\n")));
%! assert (~isempty (strfind (words.ROWS, "Drum,curvature1,,,1/m,,,2 abs\n")));
%! assert (numel (strfind (words.SIZES, 'modelVars.tubeRadius = 0.015;')), 1);
%! assert (isempty (strfind (words.SIZES, 'rest')));
%! assert (words.TAKEN, ["limits     coefFrictionPP 0.2 to 0.8, coefRollingFrictionPP ", ...
%!                       "0.02 to 0.30 (loadInput.m, part 3; smooth round grains as of ", ...
%!                       "glass: from 0.05 and 0)\n"]);
%! assert (~isempty (strfind (words.EFFECTS, '''speedError''')));
%! alone = newBenchCase (root, 'Heap');
%! assert (isempty (strfind (alone.EFFECTS, 'speedErr')));
%! assert (! isempty (strfind (alone.TAKEN, ['told       coefFrictionPP only to +- 44 %, ', ...
%!                                           'coefRollingFrictionPP only to'])), alone.TAKEN);
%!test
%! % what a person says
%! says = @(question, default, rule) ifelseText (question, default);
%! words = newBenchCase (root, 'Heap', says);
%! assert ({words.RADIUS, words.DENSITY}, {'0.001', '1150'});
%! assert (~isempty (strfind (words.ROWS, "Heap,slope,31,,deg,,,7%\n")));
%! assert (~isempty (strfind (words.ROWS, ["Heap,massOnPlate,14.1,,g,,,5%\n", ...
%!                                         "Heap,massOnPlate,13.9,,g,,,\n"])));
%! assert (strncmp (words.TAKEN, ['tolerance  Heap slope 7 %, Heap massOnPlate 5 %: twice ' ...
%!                                'what one run'], 61), words.TAKEN);
%!function text = drumTurns (question, default, rule)
%!  text = default;
%!  if ~isempty (strfind (question, 'speed 3'))
%!    [text, ~, ~] = rule ('76.4');
%!  elseif ~isempty (strfind (question, 'measured'))
%!    printf ('%s\n', question);
%!  end
%!endfunction
%!test
%! % speeds of the results as they were asked for
%! said = evalc ('newBenchCase (root, ''Drum'', @drumTurns);');
%! for part = {'middle at 19.1 turns per minute, measured, deg', 'inclination at 76.4 turns per'}
%!   assert (! isempty (strfind (said, part{1})), said);
%! end
%! assert (isempty (regexp (said, 'rad/s|rpm')), said);
%!error <got 'Drun'. Did you mean Drum> newBenchCase (root, 'Heap,Drun')
%!error id=DEcalioc:newBenchCase:badValue newBenchCase (root, 'Heap,Heap')

% SPDX-License-Identifier: GPL-3.0-only
