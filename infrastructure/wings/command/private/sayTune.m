% SAYTUNE  Looks for cheaper runs that give the same results.
%
% CALL: STATUS = sayTune (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text);  FOLDER  case folder (text)
%   ARGS    cell of texts: --vary NAME=V,V,... for each variable of data.head that
%           is to be tried (cpu: the CPUs of a run), --repeats N (default 4)
%   STATUS  0; 2 where nothing cheaper gives the same results
%
% Each value is run N times alone, the other variables as they are, with the
% parameters in the middle of the limits, all values in turn (inRounds). See
% compareVariants for what counts as the same. A value that is cheaper by far and
% shifts the results a little is proposed as a level (Input.coarse). The runs lie in
% FOLDER/tune and are used again. Seconds are those of the clock: on a busy machine
% the cost is that of a busy machine.
%
% Errors: DEcalioc:sayTune:badValue, :unknownName, those of commandOptions

function status = sayTune (root, folder, args)
  options = commandOptions (args, struct ('vary', 'many', 'repeats', 'one'));
  repeats = str2double ([options.repeats, repmat('4', 1, isempty (options.repeats))]);
  if ~(repeats >= 2 && repeats == round (repeats)) || isempty (options.vary)
    error ('DEcalioc:sayTune:badValue', ...
           ['tune takes --vary NAME=VALUE,VALUE once or more, and --repeats with a ' ...
            'whole number from 2 on, got ''%s''. decalioc tune --help shows the call.'], ...
           strjoin (args, ' '));
  end
  useLiggghts (root);
  Case = loadCase (root, folder);
  variants = [struct('name', 'as it is', 'variable', '', 'value', NaN), ...
              cellfun(@(word) variantsOf (word, Case), options.vary(:)', ...
                      'UniformOutput', false){:}];
  lock = lockCase (folder);
  Case.store = fullfile (folder, 'tune');
  Case.options.maxNewRuns = Inf;
  [~, ~] = mkdir (Case.store);
  p = toAllowed (boxCentre (Case.limits), Case);
  n = [numel(variants), repeats, numel(Case.models)];
  printf ('%s x %s x %s = %s\n', countText (n(1), 'value'), countText (n(2), 'repeat'), ...
          countText (n(3), 'model'), countText (prod (n), 'run'));
  [Z, S] = deal (cell (1, numel (variants)));
  for part = inRounds (repeats, Case.options.maxCPU)
    for k = 1:numel (variants)
      [z, s] = runVariant (variants(k), Case, p, part{1});
      Z{k} = [Z{k}; z];
      S{k} = [S{k}; s];
    end
  end
  allowed = arrayfun (@halfWidth, Case.targets);
  list = compareVariants (Z, S, allowed);
  cellfun (@(line) printf ('%s\n', line), tuneTable ({variants.name}, list, Case));
  status = 2 * ~sayBest (variants, list, Case);
end

% 'percentRayleigh=0.2,0.3' as one variant a value.
function list = variantsOf (word, Case)
  [name, values] = strtok (word, '=');
  values = str2double (strsplit (values(2:end), ','));
  if ~all (isfinite (values)) || isempty (name)
    error ('DEcalioc:sayTune:badValue', ...
           '--vary expects NAME=VALUE,VALUE with numbers, got ''%s''.', word);
  end
  known = {'cpu'};
  for model = Case.models
    known = [known, fieldnames(headOf (model))'];
  end
  if ~any (strcmp (name, known)) || any (strcmp (name, Case.names))
    error ('DEcalioc:sayTune:unknownName', ...
           ['--vary expects cpu or a variable of a data.head that is no parameter ' ...
            'of the case, got ''%s''. %s'], name, checkNearest (name, known));
  end
  list = struct ('name', arrayfun (@(v) sprintf ('%s=%g', name, v), values, ...
                                   'UniformOutput', false), ...
                 'variable', name, 'value', num2cell (values));
end

% The repeats in up to four rounds of all values, each enough for all CPUs: what else
% the machine does in the meantime slows all values.
function parts = inRounds (repeats, cpus)
  edges = round (linspace (0, repeats, 1 + max (1, min (4, floor (repeats / cpus)))));
  parts = mat2cell ((1:repeats)', diff (edges))';
end

% What the data.head of a model declares; nothing where it has none.
function defaults = headOf (model)
  file = fullfile (model.folder, 'data.head');
  defaults = struct ();
  if isfile (file)
    defaults = headDefaults (file);
  end
end

function [Z, S] = runVariant (variant, Case, p, part)
  if strcmp (variant.variable, 'cpu')
    [Case.models.cpu] = deal (variant.value);
  elseif ~isempty (variant.variable)
    Case.modelVars.(variant.variable) = variant.value;
  end
  say = @(text) printf ('%s\n', text);
  [Z, records] = evaluateDEM (repmat (p, numel (part), 1), Case, part, 'tune', ...
                              newProgress (variant.name, say));
  S = reshape ([records.seconds], size (records)) * [Case.models.cpu]';
end

% The cheapest value with the same results; and one that is cheaper by far, whose
% shift a level carries. Worth a level is what costs less than half and shifts no
% result by more than a tenth: in the study coarseRuns levels saved a sixth of the
% cost where they were off by 5 %, and cost an eighth more at 15 % (benchmarks).
function isFound = sayBest (variants, list, Case)
  share = arrayfun (@(v) v.ratio(1), list);
  most = arrayfun (@(v) v.ratio(3), list);
  off = arrayfun (@(v) max (abs (v.shift ./ [Case.targets.value])), list);
  isSame = strcmp ({list.code}, 'same') & most < 1;
  isFound = any (isSame);
  if isFound
    k = cheapest (share, isSame);
    v = variants(k);
    places = {sprintf('modelVars.%s = %g;', v.variable, v.value), ...
              sprintf('Input.cpu = %g;', v.value)};
    propose ('tune.best', share(k), places{1 + strcmp(v.variable, 'cpu')});
  else
    printf ('%s\n', sentence ('tune.none'));
  end
  isLevel = most < 0.5 & off <= 0.1 & ~isSame & ~strcmp ({variants.variable}, 'cpu');
  if any (isLevel)
    k = cheapest (share, isLevel);
    cellfun (@(line) propose ('tune.level', share(k), line), ...
             coarseLines (variants(k), Case));
  end
end

function k = cheapest (share, isIt)
  share(~isIt) = Inf;
  [~, k] = min (share);
end

function propose (key, share, line)
  values = struct ('line', line, 'share', sprintf ('%.3g %%', 100 * share));
  printf ('%s\n', sentence (key, values));
end

% One line of loadInput.m for each model that has the variable.
function lines = coarseLines (variant, Case)
  lines = {};
  for k = 1:numel (Case.models)
    declared = givenField (headOf (Case.models(k)), variant.variable, NaN);
    today = givenField (Case.modelVars, variant.variable, declared);
    if isfinite (declared)
      lines{end + 1} = sprintf (['Input.coarse{%d} = struct (''variable'', ''%s'', ' ...
                                 '''levels'', [%g, %g]);'], k, variant.variable, ...
                                variant.value, today);
    end
  end
end

%!function folder = slowCase ()
%!  % a model whose runs get cheaper with e, and shift by it
%!  raw = standInCase (tempname ());
%!  writeLoadInput (raw.folder);
%!  for name = {'First', 'Second'}
%!    file = fullfile (raw.folder, 'DEMmodels', name{1}, 'runscript');
%!    writeAtomic (file, ["sleep $(awk '$2 == \"slow\" { s = $4 } END { print s }' ", ...
%!                        "data.head)\n", fileread(file)]);
%!    head = fullfile (raw.folder, 'DEMmodels', name{1}, 'data.head');
%!    writeAtomic (head, ["variable slow equal 0.6\n", fileread(head)]);
%!  end
%!  folder = raw.folder;
%!endfunction
%!test
%! % how much cheaper, the clock says, which on a busy machine is no test
%! [status, text] = startCommand (slowCase (), 'tune --vary slow=0.01 --vary e=9 --repeats 2');
%! assert (any (status == [0, 2]), text);
%! assert (~isempty (strfind (text, '3 values x 2 repeats x 2 models = 12 runs')), text);
%! assert (~isempty (regexp (text, 'slow=0.01 [^\n]*the same')), text);
%! assert (~isempty (regexp (text, 'e=9 .*shifts by \+9')), text);
%!test
%! folder = slowCase ();
%! root = fileparts (fileparts (which ('startToolbox')));
%! here = cd (folder);
%! back = onCleanup (@() cd (here));
%! clear loadInput
%! for words = {'--vary slo=1', 'Did you mean slow?'; '--vary a=1', 'no parameter'; ...
%!              '--vary slow=x', 'with numbers'; '', 'once or more'; ...
%!              '--vary slow=1 --repeats 1', 'from 2 on'}'
%!   text = '';
%!   try
%!     sayTune (root, folder, strsplit (words{1}, ' '));
%!   catch err
%!     text = err.message;
%!   end
%!   assert (~isempty (strfind (text, words{2})), text);
%! end

% SPDX-License-Identifier: GPL-3.0-only
