% CASETOREAD  Loads a case for a command that only reads its files.
%
% CALL: [CASE, NOTE] = caseToRead (ROOT, FOLDER)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   CASE    see newCase, with effects; nothing can be run of it, so neither
%           LIGGGHTS nor a program of a queue need be on this machine, nor a
%           place that can be written to
%   NOTE    a sentence for the user where LIGGGHTS is not on this machine and a
%           model calls it, so that none of its runs is known as one of today
%           (see hashModels); else ''
%
% Errors: those of loadCase and withEffects

function [Case, note] = caseToRead (root, folder)
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder, 'reading'));
  note = '';
  scripts = cellfun (@(f) checkReadText (fullfile (f, 'runscript')), ...
                     {Case.models.folder}, 'UniformOutput', false);
  if isempty (file_in_path (getenv ('PATH'), 'liggghts')) && ...
     ~isempty (regexpi ([scripts{:}], 'liggghts', 'once'))
    note = sprintf (['NOTE    there is no liggghts on this machine: runs ' ...
                     'that were made with one count\n        as those of ' ...
                     'an earlier model here.\n']);
  end
end

%!test
%! % commands that only read, where the program of the runs is not
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'runscript'), ...
%!              "noSuchDEM < in.First\n");
%! [status, text] = startCommand (raw.folder, 'report');
%! assert (status == 0, text);
%! [status, text] = startCommand (raw.folder, 'check');
%! assert (status, 1);
%! assert (~isempty (strfind (text, 'a program noSuchDEM on the PATH')), text);
%!test
%! % where LIGGGHTS itself is not, that is said
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! before = {getenv('PATH'), getenv('LIGGGHTS'), getenv('XDG_CACHE_HOME')};
%! names = {'PATH', 'LIGGGHTS', 'XDG_CACHE_HOME'};
%! back = onCleanup (@() cellfun (@setenv, names, before));
%! path = [OCTAVE_EXEC_HOME(), '/bin:/usr/bin:/bin'];
%! cellfun (@setenv, names, {path, '', tempname()});
%! mark = 'NOTE    there is no liggghts';
%! [~, text] = startCommand (raw.folder, 'status');
%! assert (isempty (strfind (text, mark)), text);
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'runscript'), ...
%!              "liggghts < in.First\n");
%! isThere = ~isempty (file_in_path (path, 'liggghts'));
%! [status, text] = startCommand (raw.folder, 'status');
%! assert (status == 0, text);
%! assert (isempty (strfind (text, mark)) == isThere, text);
%! % nor does it keep a command from reading that LIGGGHTS names none
%! setenv ('LIGGGHTS', '/nowhere/liggghts');
%! [status, text] = startCommand (raw.folder, 'cancel');
%! assert (status == 0, text);

% SPDX-License-Identifier: GPL-3.0-only
