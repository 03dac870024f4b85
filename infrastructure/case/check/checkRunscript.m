% CHECKRUNSCRIPT  Checks that the runscript of a model can run.
%
% CALL: P = checkRunscript (MODEL, HOW)
%
%   MODEL  scalar struct with the fields name, folder and cpu, see
%          checkFindModels
%   HOW    scalar struct of booleans: onCluster (runs start on another machine:
%          programs are not looked for), programs (bash may be started)
%   P      1 x n faults, see checkFault
%
% bash reads the script (bash -n), nothing in it is run. Of the programs,
% liggghts, mpirun and mpiexec are looked for wherever they stand, any other
% where the script is one plain command, as in the user document.
%
% Reasons: emptyRunscript badRunscript windowsLineEnds missingProgram
% missingInputFile rankMismatch

function p = checkRunscript (model, how)
  field = ['DEMmodels/', model.name, '/runscript'];
  file = fullfile (model.folder, 'runscript');
  text = checkReadText (file);
  lines = commandLines (text);
  if isempty (lines)
    p = checkFault ('emptyRunscript', field, 'a command', ...
                    'a file without any', ...
                    'Write for example: liggghts < in.Model');
    return
  elseif any (text == "\r")
    p = checkFault ('windowsLineEnds', field, ...
                    'lines that end in a line feed alone', ...
                    'Windows line ends', ...
                    'Run: sed -i ''s/\r$//'' runscript');
    return
  elseif any (text == 0)
    p = checkFault ('badRunscript', field, 'a bash script', ...
                    'a binary file', ...
                    'Write for example: liggghts < in.Model');
    return
  end
  status = 0;
  if how.programs
    [status, out] = system (['LC_ALL=C bash -n ', shellQuote(file), ' 2>&1']);
  end
  if status ~= 0
    p = checkFault ('badRunscript', field, ...
                    'a script that bash can read', ...
                    checkShow (strrep (strtok (out, "\n"), ...
                                       [file, ': '], '')), ...
                    'Try it with: bash -n runscript');
    return
  end
  p = [checkPrograms(field, lines, how.onCluster), ...
       checkInputFile(field, lines, model), checkRanks(field, lines, model)];
end

% Lines that hold a command; a trailing comment is cut off.
function lines = commandLines (text)
  lines = strsplit (strrep (text, "\\\n", ' '), "\n");
  lines = strtrim (regexprep (lines, '(^|\s)#.*$', ''));
  lines = lines(~cellfun (@isempty, lines));
end

function p = checkPrograms (field, lines, onCluster)
  p = checkFault ();
  text = strjoin (lines, "\n");
  setsPath = {'PATH=', 'module ', 'source ', '. /', 'command -v', 'which ', ...
              'type ', 'hash ', 'conda', 'spack'};
  if onCluster || ...
      any (cellfun (@(w) ~isempty (strfind (text, w)), setsPath))
    return
  end
  names = unique (programs (lines));
  for k = 1:numel (names)
    if isempty (file_in_path (getenv ('PATH'), names{k}))
      p(end + 1) = checkFault ('missingProgram', field, ...
                               sprintf ('a program %s on the PATH', ...
                                        names{k}), 'none', ...
                               cureProgram (names{k}));
    end
  end
end

function cure = cureProgram (name)
  cure = 'Install it, or write its full path.';
  if strcmp (name, 'liggghts')
    cure = 'Build it with: make liggghts; or write the full path of yours.';
  end
end

function names = programs (lines)
  words = strsplit (strjoin (lines, ' '), {' ', "\t", ';', '&', '|', '(', ...
                                           ')', '<', '>'});
  for k = find (~cellfun (@isempty, strfind (words, '${')))
    words{k} = withDefault (words{k});
  end
  names = words(ismember (words, {'liggghts', 'mpirun', 'mpiexec'}));
  if isscalar (lines) && ~any (ismember (lines{1}, ';&|()<>$`"''={}!'))
    names{end + 1} = strtok (lines{1});
  elseif isscalar (lines)
    plain = regexp (lines{1}, '^([\w.+-]+)\s*<\s*[\w./+-]+$', 'tokens', ...
                    'once');
    names = [names, plain];
  end
  names = names(cellfun (@(n) isempty (strfind (n, '/')), names));
  builtin = {'exec', 'true', 'false', 'exit', 'echo', 'printf', 'cd', ...
             'export', 'time', 'set', 'test', 'eval', ':', '.', '['};
  names = names(~ismember (names, builtin));
end

% ${LIGGGHTS:-liggghts} stands for liggghts where LIGGGHTS is not set.
function word = withDefault (word)
  parts = regexp (word, '^\$\{(\w+):?-(\w+)\}$', 'tokens', 'once');
  if numel (parts) == 2 && isempty (getenv (parts{1}))
    word = parts{2};
  end
end

function p = checkInputFile (field, lines, model)
  p = checkFault ();
  if numel (lines) > 1
    return
  end
  name = regexp (lines{1}, 'liggghts.*(?:<|\s-i|\s-in)\s*([\w.+-]+)\s*$', ...
                 'tokens', 'once');
  if ~isempty (name) && ~isfile (fullfile (model.folder, name{1}))
    p = checkFault ('missingInputFile', field, ...
                    'an input file that is in the model folder', name{1}, ...
                    'Correct the name; upper and lower case differ.');
  end
end

function p = checkRanks (field, lines, model)
  p = checkFault ();
  for k = 1:numel (lines)
    n = regexp (lines{k}, ...
                '\<(?:mpirun|mpiexec)\>.*\s(?:-n|-np|--np|-c)\s+(\d+)\s', ...
                'tokens', 'once');
    if ~isempty (n) && str2double (n{1}) > model.cpu
      p = checkFault ('rankMismatch', field, ...
                      sprintf ('at most Input.cpu = %d rank(s)', ...
                               model.cpu), ['mpirun with ', n{1}], ...
                      sprintf ('Set Input.cpu of this model to %s.', n{1}));
      return
    end
  end
end

%!function p = tryScript (code, cpu, onCluster)
%!  how = struct ('programs', true, 'onCluster', onCluster);
%!  folder = tempname ();
%!  mkdir (folder);
%!  fid = fopen (fullfile (folder, 'runscript'), 'w');
%!  fputs (fid, code);
%!  fclose (fid);
%!  model = struct ('name', 'Toy', 'folder', folder, 'cpu', cpu);
%!  p = checkRunscript (model, how);
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!endfunction
%!test
%! rowsOf = {"# a comment\nawk 1 data.head > out", false, ''; ...
%!           'noSuchDEM < in.x', true, ''; ...
%!           "# nothing\n\n", false, 'emptyRunscript'; ...
%!           "if true; then\n", false, 'badRunscript'; ...
%!           "true\r\n", false, 'windowsLineEnds'; ...
%!           'noSuchDEM in.x', false, 'missingProgram'; ...
%!           'noSuchDEM < in.x', false, 'missingProgram'; ...
%!           'mpirun -np 4 liggghts -in x', true, 'rankMismatch'; ...
%!           'liggghts < in.x', true, 'missingInputFile'};
%! for row = rowsOf'
%!   p = tryScript (row{1}, 1, row{2});
%!   assert (isempty (p) == isempty (row{3}), row{1});
%!   if ! isempty (p)
%!     assert (p(end).id, ['DEcalioc:checkCase:', row{3}]);
%!   end
%! end
