//! Schema of a channel: of all descriptors only those that its messages need. Each of the two
//! channels of a key must contain its schema, and all descriptors would be megabytes per client.

use std::collections::BTreeSet;

use data_encoding::BASE64;
use prost::Message as _;
use prost_types::{DescriptorProto, FileDescriptorProto, FileDescriptorSet};

use crate::{DESCRIPTORS, Topic};

/// Returns the schema of `topic`'s messages: a `google.protobuf.FileDescriptorSet` in base64.
pub fn schema(topic: Topic) -> String {
    BASE64.encode(&descriptors(topic.schema()))
}

/// Returns the descriptors of the message type `name` and of those that it contains.
fn descriptors(name: &str) -> Vec<u8> {
    // The descriptors are ours, and a test decodes them; unreduced they are valid as well.
    let Ok(set) = FileDescriptorSet::decode(DESCRIPTORS) else { return DESCRIPTORS.to_vec() };
    let file = set.file.into_iter().map(|file| reduced(file, name)).collect();
    FileDescriptorSet { file }.encode_to_vec()
}

fn reduced(mut file: FileDescriptorProto, name: &str) -> FileDescriptorProto {
    let package = format!(".{}.", file.package());
    let mut needed = BTreeSet::from([format!(".{name}")]);
    // Each round adds the types of the last ones, so there are at most as many rounds as types.
    for _ in 0..file.message_type.len() {
        for message in &file.message_type {
            if needed.contains(&format!("{package}{}", message.name())) {
                needed.extend(contained(message));
            }
        }
    }
    file.source_code_info = None;
    file.message_type.retain(|message| needed.contains(&format!("{package}{}", message.name())));
    file
}

fn contained(message: &DescriptorProto) -> impl Iterator<Item = String> {
    let types = message.field.iter().filter_map(|field| field.type_name.clone());
    types.filter(|name| !name.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn types(topic: Topic) -> BTreeSet<String> {
        let bytes = BASE64.decode(schema(topic).as_bytes()).expect("base64");
        let set = FileDescriptorSet::decode(bytes.as_slice()).expect("descriptors");
        assert_eq!(set.file.len(), 1);
        set.file[0].message_type.iter().map(|message| message.name().to_owned()).collect()
    }

    #[test]
    fn every_topic_s_type_is_in_its_schema() {
        for topic in Topic::all() {
            let short = topic.schema().trim_start_matches("letoff.telemetry.");
            assert!(types(topic).contains(short), "{topic}");
        }
    }
}
