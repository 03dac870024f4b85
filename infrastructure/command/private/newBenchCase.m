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
%   WORDS  scalar struct of texts for fillTemplate of templates/benchCase
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
  words.DENSITY = ask ('density of a grain (not of the bulk), kg/m3', ...
                       '1200', @(text) sizeIn (text, 'kg/m3'));
  words.RADIUS = ask ('radius of a grain, m', '2e-3', ...
                      @(text) sizeIn (text, 'm'));
  words.MODELS = quoted ({benches.name});
  words.CPUS = strjoin (repmat ({'1'}, 1, numel (benches)), ', ');
  words.SIZES = sizeLines (benches);
  rows = arrayfun (@(bench) rowsOf (bench, ask), benches, ...
                   'UniformOutput', false);
  words.ROWS = [rows{:}];
  words.EFFECTS = effectLines (quoted, candidatesOf (benches));
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

function [text, fault] = sizeIn (text, unit)
  [text, fault] = amountIn (text, unit);
  if isempty (fault) && ~(str2double (text) > 0)
    fault = sprintf ('more than 0 %s is needed, got %s.', unit, text);
  end
end

function text = rowsOf (bench, ask)
  text = '';
  for k = 1:numel (bench.results)
    one = bench.results(k);
    tol = 2 * bench.sd(k) / abs (bench.mean(k));
    words = sprintf ('%.0f%%', ceil (100 * max (tol, 0.02)));
    if tol > 0.4
      words = sprintf ('%.1g abs', 2 * bench.sd(k));
    end
    value = ask (sprintf ('%s: %s, measured, %s (empty: not measured)', ...
                          bench.name, one.text, one.unit), '', ...
                 @(text) amountIn (text, one.unit));
    text = [text, sprintf('%s,%s,%s,,%s,,,%s\n', bench.name, one.name, ...
                          value, one.unit, words)];
  end
end

% Effects that one rig at least can express, the commonest ones.
function names = candidatesOf (benches)
  names = {'cohesion', 'liquidBridge', 'wallAdhesion', 'shape', ...
           'sizeSpread', 'meanSize', 'fill', 'tilt', 'opening', ...
           'liftSpeed', 'lidWeight', 'speedError', 'timeOffset', 'cameraRoll'};
  effects = resolveEffects (names);
  can = false (1, numel (names));
  for bench = benches
    can = can | effectsOfModel (bench.folder, effects);
  end
  names = names(can);
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
%!  if ~isempty (strfind (question, 'radius'))
%!    text = '0.001';
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
%! assert (~isempty (strfind (words.EFFECTS, '''speedError''')));
%! assert (isempty (strfind (newBenchCase (root, 'Heap').EFFECTS, 'speedErr')));
%!test
%! % what a person says
%! says = @(question, default, rule) ifelseText (question, default);
%! words = newBenchCase (root, 'Heap', says);
%! assert ({words.RADIUS, words.DENSITY}, {'0.001', '1200'});
%! assert (~isempty (strfind (words.ROWS, "Heap,slope,31,,deg,,,7%\n")));
%!error <got 'Drun'. Did you mean Drum> newBenchCase (root, 'Heap,Drun')
%!error id=DEcalioc:newBenchCase:badValue newBenchCase (root, 'Heap,Heap')
