% GETEFFECT  Description of one effect of the library.
%
% CALL: EFFECT = getEffect (NAME)
%       EFFECT = getEffect (NAME, FOLDERS)
%
% NAME     name of the effect, as listEffects gives it
% FOLDERS  text or cell of folders that are looked in before the library
% EFFECT   scalar struct, see describeEffect, which fills in what the file leaves
%          out
%
% Throws DEcalioc:getEffect:unknownName, DEcalioc:getEffect:badFile.
%
% See also: describeEffect, listEffects, resolveEffects
function effect = getEffect (name, folders)
  if nargin < 2
    folders = {};
  end
  [names, files] = listEffects (folders);
  k = find (strcmp (names, name));
  if isempty (k)
    error ('DEcalioc:getEffect:unknownName', ...
           'getEffect: NAME must be one of %s, got %s.', ...
           strjoin (names, ', '), name);
  end
  [folder, base] = fileparts (files{k});
  if ~any (strcmp (strsplit (path (), pathsep ()), folder))
    addpath (folder);
    restore = onCleanup (@() rmpath (folder));
  end
  try
    effect = feval (base);
  catch err
    error ('DEcalioc:getEffect:badFile', 'getEffect: %s must run, got: %s', ...
           files{k}, err.message);
  end
  if ~isstruct (effect) || ~isscalar (effect)
    error ('DEcalioc:getEffect:badFile', ...
           ['getEffect: %s must give a struct with name, variables, neutral and ' ...
            'limits, got %s.'], files{k}, describeValue (effect));
  end
  try
    effect = describeEffect (mergeFields (struct ('name', name), effect));
  catch err
    error (err.identifier, '%s (of %s)', err.message, files{k});
  end
end

%!test
%! e = getEffect ('cohesion');
%! assert (e.variables, {'cohesionPP'});
%! assert (e.neutral, 0);

%!test % every file of the library describes the effect of its name
%! for name = listEffects ()
%!   assert (getEffect (name{1}).name, name{1});
%! end

%!test % a file in a folder that is not on the path
%! folder = emptyFolder ();
%! file = fullfile (folder, 'effectTrialOfGetEffect.m');
%! fid = fopen (file, 'w');
%! fputs (fid, ["function e = effectTrialOfGetEffect ()\n", ...
%!   "e = describeEffect (struct ('name', 'trialOfGetEffect', ", ...
%!   "'variables', {{'q'}}, 'neutral', 0, 'limits', [0; 2]));\nend\n"]);
%! fclose (fid);
%! e = getEffect ('trialOfGetEffect', folder);
%! delete (file);
%! rmdir (folder);
%! assert (e.priorScale, 4);

%!test
%! % the four fields alone, a field that is missing, what is no struct
%! [folder, put] = emptyFolder ();
%! lines = {"e = struct ('variables', {{'q'}}, 'neutral', 0, 'limits', [0; 2]);", ...
%!          "e = struct ('variables', {{'q'}}, 'neutral', 0);", 'e = 7;'};
%! for k = 1:3
%!   name = sprintf ('ownOfGetEffect%d', k);
%!   put (['effectO', name(2:end), '.m'], ...
%!        ["function e = effectO", name(2:end), " ()\n", lines{k}, "\nend\n"]);
%! end
%! e = getEffect ('ownOfGetEffect1', folder);
%! assert ({e.group, e.priorScale, e.usually}, {'ownOfGetEffect1', 4, 'yes'});
%! fail ('getEffect (''ownOfGetEffect2'', folder)', 'field limits. .of .*Effect2.m');
%! fail ('getEffect (''ownOfGetEffect3'', folder)', 'Effect3.m must give a struct');

%!error id=DEcalioc:getEffect:unknownName getEffect ('noSuchEffect')
