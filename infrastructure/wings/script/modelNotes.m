% MODELNOTES  What a model's LIGGGHTS script may not do as it is meant.
%
% CALL: [NOTES, CODES] = modelNotes (FOLDER)
%
%   FOLDER  model folder (text)
%   NOTES   1 x n cell of sentences without their last point
%   CODES   1 x n cell: missing (a file that a script names), open (a name that
%           is known in a run alone), lost, inert (scriptPhysics), seed, end, run,
%           unused, loop, own (a variable), output (nothing writes the file of the
%           results)
%
% Of a model whose runscript starts LIGGGHTS with one script by -in, -i or <.
% seed ... own are said of models that hand their variables over by -var, which
% decalioc new --script makes; of others newCase looks at the variables.

function [notes, codes] = modelNotes (folder)
  [notes, codes] = deal (cell (1, 0));
  run = readText (fullfile (folder, 'runscript'));
  [script, start] = scriptOf (run, folder);
  if isempty (script)
    return
  end
  given = struct ();
  seed = regexp (run, '\$2 == "runSeed" \? "(\w+)"', 'tokens', 'once');
  isHanded = ~isempty (seed);
  if isHanded
    given = headDefaults (fullfile (folder, 'data.head'));
  end
  found = scriptFiles (script, start, given);
  isMade = @(text) ~isempty (strfind (run, regexprep (strtok (text, ' '), ...
                                                      '^.*/', '')));
  missing = found.missing(~cellfun (isMade, found.missing));
  for name = stagesOf (folder)           % its last state is there in a run
    of = [name{1}, '/'];
    missing(strncmp (missing, of, numel (of))) = [];
  end
  notes = [strcat(missing, {[': there is no such file. A run will stop there; ' ...
                             'put it into the model']}), ...
           strcat(found.open, {[': its name is known in a run alone. See that ' ...
                                'the file is in the model']})];
  codes = [repmat({'missing'}, 1, numel (missing)), ...
           repmat({'open'}, 1, numel (found.open))];
  [texts, kinds] = scriptPhysics (found.text, found.commands);
  [notes, codes] = deal ([notes, texts], [codes, kinds]);
  if isHanded
    [texts, kinds] = scriptNotes (found.text, seed{1}, ...
                                  setdiff (fieldnames (given)', 'runSeed'));
    % a script that is not there may have it
    isKnown = ~strcmp (kinds, 'run') | isempty ([missing, found.open]);
    [notes, codes] = deal ([notes, texts(isKnown)], [codes, kinds(isKnown)]);
    output = regexp (run, '^rm -f -- ''([^'']+)''', 'tokens', 'once', 'lineanchors');
    if ~isempty (output) && isempty ([missing, found.open]) && ...
       ~mayWrite (found, run, output{1}, start, folder)
      codes{end + 1} = 'output';
      notes{end + 1} = ['no line of the script writes ', output{1}, ', where the ', ...
                        'results are looked for. Name the file that it writes with ', ...
                        '--output, or the program that makes it with --post'];
    end
  end
end

% By a command, by a name that is known in a run alone, or by another program that
% the script or RUN, the text of the runscript, calls; or getResults reads no such file.
function yes = mayWrite (found, run, output, start, folder)
  [~, base, ending] = fileparts (output);
  behind = regexp (run, '\s-in [^\n]*\n(.*)$', 'tokens', 'once');
  reader = readText (fullfile (folder, 'OctaveFuns', 'getResults.m'));
  yes = isempty (regexp (reader, '^[^%\n]*readResults \(', 'once', 'lineanchors')) || ...
        any (strcmp (found.written, plainPath (fullfile (start, output)))) || ...
        strcmp (output, 'log.liggghts') || ...
        ~isempty (regexp (found.text, '^[ \t]*shell[ \t]+(?!cd|mkdir|rm\>)', 'once', ...
                          'lineanchors')) || ...
        ~isempty (regexp (found.text, '(file|append|log)[ \t]+\S*\$', 'once')) || ...
        ~isempty (regexp (regexprep (found.text, '#[^\n]*', ''), ...
                          ['(?<![\w./-])(\./)?', regexptranslate('escape', [base, ending])], ...
                          'once')) || ...
        ~isempty (strtrim ([behind{:}, '']));
end

% The script that RUN, the text of a runscript, starts, and in which folder.
function [script, start] = scriptOf (run, folder)
  script = '';
  run = regexprep (run, '^[ \t]*#[^\n]*', '', 'lineanchors');
  word = '(''[^'']*''|"[^"]*"|[^\s''"<>()&;|]+)';
  place = regexp (run, ['^[ \t]*cd[ \t]+(?:--[ \t]+)?', word], 'tokens', ...
                  'once', 'lineanchors');
  start = fullfile (folder, regexprep ([place(:)', {''}]{1}, ...
                                       '^["'']|["'']$', ''));
  lines = strsplit (regexprep (run, '\\\n', ' '), "\n");
  isStart = ~cellfun (@isempty, regexpi (lines, ['liggghts|lmp|lammps|launch|', ...
                                                 '\$\{?\w*lig\w*\}?[ \t]'], 'once'));
  names = regexp (lines(isStart), ['(?:\s-in?[ \t]+|<[ \t]*)', word], 'tokens');
  names = [cell(1, 0), names{:}];
  for name = regexprep ([cell(1, 0), names{:}], '^["'']|["'']$', '')
    if isfile (fullfile (start, name{1})) && ~strcmp (name{1}, 'data.head')
      script = fullfile (start, name{1});
    end
  end
end

%!function [notes, codes] = of (run, script, head)
%!  [folder, put] = emptyFolder ();
%!  put ('runscript', run);
%!  put ('in.x', script);
%!  put ('data.head', head);
%!  [notes, codes] = modelNotes (folder);
%!endfunction
%!test
%! script = ["include data.head\nread_data no.data\ninclude ${what}\n", ...
%!           "read_restart made.rst\nread_restart '${a}'\n"];
%! for run = {"#!/bin/bash\n./make made.rst\nliggghts < in.x\n", ...
%!            "mpirun -np 2 liggghts -in \"in.x\" # made.rst\n", ...
%!            "cp a made.rst\ncd .\nlmp_auto -i in.x\n"}
%!   [notes, codes] = of (run{1}, script, "variable a equal 1\n");
%!   assert (codes, {'missing', 'missing', 'open'});
%!   assert (strtok (notes), {'1', 'no.data', '${what}'});
%! end
%!assert (isempty (of ("awk 1 < in.x\n", 'include no', "variable a equal 1\n")))
%!test
%! % the models of the toolbox
%! root = fileparts (fileparts (which ('startToolbox')));
%! for name = {'Heap', 'Drum', 'SlotBin', 'Lift100'}
%!   assert (modelNotes (fullfile (root, 'DEMmodels', name{1})), cell (1, 0));
%! end

% SPDX-License-Identifier: GPL-3.0-only
